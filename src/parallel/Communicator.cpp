#include "parallel/Communicator.h"

namespace mpsDem {

int Communicator::ranks() { return 1; }
int Communicator::rank() { return 0; }

void Communicator::sum(std::span<Real>) {}
void Communicator::sum(std::span<std::int64_t>) {}
void Communicator::min(std::span<Real>) {}
void Communicator::max(std::span<Real>) {}

} // namespace mpsDem
