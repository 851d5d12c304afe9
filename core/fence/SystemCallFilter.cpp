// SPDX-License-Identifier: Apache-2.0
#include "core/fence/SystemCallFilter.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace core::fence {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t processor = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t processor = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t processor = 0;
#endif

using Program = std::vector<sock_filter>;

constexpr std::uint32_t callAt = offsetof(seccomp_data, nr);
constexpr std::uint32_t processorAt = offsetof(seccomp_data, arch);

/// The low half of an argument: both processors are little endian.
constexpr std::uint32_t argumentAt(int index)
{
    return std::uint32_t(offsetof(seccomp_data, args)) + 8 * std::uint32_t(index);
}

void load(Program& program, std::uint32_t at)
{
    program.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, at));
}

void answer(Program& program, std::uint32_t action)
{
    program.push_back(BPF_STMT(BPF_RET | BPF_K, action));
}

void allow(Program& program, long call)
{
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(call), 0, 1));
    answer(program, SECCOMP_RET_ALLOW);
}

/// Allowed if the argument is this number.
void allowWith(Program& program, long call, int argument, std::uint32_t value)
{
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(call), 0, 4));
    load(program, argumentAt(argument));
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1));
    answer(program, SECCOMP_RET_ALLOW);
    answer(program, SECCOMP_RET_KILL_PROCESS);
}

/// Allowed if the argument has none of these bits.
void allowWithout(Program& program, long call, int argument, std::uint32_t bits)
{
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(call), 0, 4));
    load(program, argumentAt(argument));
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, bits, 1, 0));
    answer(program, SECCOMP_RET_ALLOW);
    answer(program, SECCOMP_RET_KILL_PROCESS);
}

Program makeProgram(int descriptor)
{
    Program program;
    load(program, processorAt);
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, processor, 1, 0));
    answer(program, SECCOMP_RET_KILL_PROCESS);
    load(program, callAt);
    allowWith(program, SYS_read, 0, std::uint32_t(descriptor));
    allowWith(program, SYS_write, 0, std::uint32_t(descriptor));
    // Memory, but none that becomes code.
    allowWithout(program, SYS_mmap, 2, PROT_EXEC);
    allowWithout(program, SYS_mprotect, 2, PROT_EXEC);
    for (const long call : {SYS_munmap, SYS_mremap, SYS_brk, SYS_madvise, SYS_futex, SYS_exit,
             SYS_exit_group, SYS_rt_sigreturn, SYS_rt_sigprocmask, SYS_clock_gettime,
             SYS_gettimeofday, SYS_getpid, SYS_gettid, SYS_getrandom, SYS_sched_yield})
        allow(program, call);
    // abort() ends the process that calls it; others it may not reach.
    allowWith(program, SYS_tgkill, 0, std::uint32_t(getpid()));
    answer(program, SECCOMP_RET_KILL_PROCESS);
    return program;
}

} // namespace

bool filterSystemCalls(int descriptor)
{
    if (processor == 0)
        return false;
    Program program = makeProgram(descriptor);
    const sock_fprog filter{
        .len = static_cast<unsigned short>(program.size()), .filter = program.data()};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0
        && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

} // namespace core::fence
