// SPDX-License-Identifier: Apache-2.0
#include "app/end/SuddenEnd.h"

#include "app/end/CallerOfNew.h"
#include "app/end/EndNote.h"
#include "core/base/MemoryReserve.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include <unistd.h>

namespace app {

namespace {

std::atomic<int> note = -1;

// Everything below is called where no memory may be taken and no lock.

void write(int descriptor, const char* text)
{
    if (descriptor >= 0)
        static_cast<void>(!::write(descriptor, text, std::strlen(text)));
}

void onCrash(int number)
{
    if (core::memoryWasRefused() || core::isMemoryShort())
        endForWantOfMemory();
    write(note, EndNote::crashed);
    write(STDERR_FILENO,
        "burin: an error in the program or in a library ends it; every step so far is in its "
        "session\n");
    std::signal(number, SIG_DFL);
    std::raise(number);
}

bool isForWantOfMemory()
{
    try {
        if (std::current_exception())
            throw;
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
    }
    return core::memoryWasRefused();
}

[[noreturn]] void onTerminate()
{
    if (isForWantOfMemory())
        endForWantOfMemory();
    std::abort();
}

} // namespace

void endForWantOfMemory()
{
    write(note, EndNote::outOfMemory);
    write(STDERR_FILENO,
        "burin: not enough memory: the program has to end; every step so far is in its session\n");
    ::_exit(EXIT_FAILURE);
}

void watchForSuddenEnd()
{
    core::keepMemoryReserve();
    prepareToNameCallers();
    std::set_terminate(onTerminate);
    // A stack that has overflowed is of no use to a handler.
    static std::array<char, 65536> stack;
    stack_t other{};
    other.ss_sp = stack.data();
    other.ss_size = stack.size();
    ::sigaltstack(&other, nullptr);
    struct sigaction action { };
    action.sa_handler = onCrash;
    action.sa_flags = SA_ONSTACK | SA_NODEFER;
    for (const int number : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL})
        ::sigaction(number, &action, nullptr);
}

void noteSuddenEndIn(int descriptor)
{
    note = descriptor;
}

} // namespace app
