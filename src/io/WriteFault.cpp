#include "io/WriteFault.h"

#include <cerrno>

namespace mpsDem {

namespace {

int failing = 0;
bool allAfter = false;
int operations = 0;

} // namespace

void setWriteFault(int nth, bool andAfter)
{
    failing = nth;
    allAfter = andAfter;
    operations = 0;
}

int writeOperations() { return operations; }

bool writeFaultDue()
{
    ++operations;
    bool const due = failing > 0 && (operations == failing || (allAfter && operations > failing));
    if (due) errno = EIO;
    return due;
}

} // namespace mpsDem
