#pragma once

namespace mpsDem {

/// For tests only: makes the nth write, fsync, close, rename or folder operation of this process fail with "Input/output error".
///
/// Counting starts at 1 with this call. It is compiled into the library so that the tests run the code that users run; without a call
/// it costs one comparison an operation. Not thread-safe: files are written by one thread.
/// @param nth       Operation that fails; 0 switches the fault off.
/// @param andAfter  Every later operation fails too, as on a full disk; otherwise only this one.
void setWriteFault(int nth, bool andAfter = false);

/// Number of operations since the last call of setWriteFault.
int writeOperations();

/// Counts one operation. True, with errno set to EIO, where this one is to fail.
bool writeFaultDue();

} // namespace mpsDem
