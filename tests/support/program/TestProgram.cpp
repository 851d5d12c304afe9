// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <execinfo.h>
#include <unistd.h>

namespace test {

namespace {

// Inside a function: sources register before any other global is sure to exist.
std::map<std::string, TestRun>& runs()
{
    static std::map<std::string, TestRun> all;
    return all;
}

// Compiling a kernel for a software driver takes longer than most tests: all of them, and the
// programs that they start in homes of their own, share what one of them has compiled.
void shareCompiledShaders()
{
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    const auto shaders = program.parent_path() / "compiled-shaders";
    std::error_code failed; // then they are compiled where Mesa would keep them
    std::filesystem::create_directories(shaders, failed);
    if (!failed)
        setenv("MESA_SHADER_CACHE_DIR", shaders.c_str(), 0);
}

// Calls nothing that takes a lock or memory: the heap may be what is broken.
void tellStack(int number)
{
    constexpr int deepest = 64;
    void* frames[deepest];
    const char told[] = "The test crashed; its stack (addr2line -Cfpe tells the lines):\n";
    static_cast<void>(!::write(STDERR_FILENO, told, sizeof(told) - 1));
    backtrace_symbols_fd(frames, backtrace(frames, deepest), STDERR_FILENO);
    std::signal(number, SIG_DFL);
    std::raise(number);
}

void tellStacks()
{
    void* frame = nullptr;
    backtrace(&frame, 1); // loads what it needs while that is safe
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        std::signal(number, tellStack);
}

} // namespace

int execute(QObject& test, int argc, char** argv)
{
    std::string noHandler = "-nocrashhandler";
    std::vector<char*> arguments(argv, argv + argc);
    arguments.insert(arguments.begin() + 1, noHandler.data());
    arguments.push_back(nullptr);
    tellStacks();
    return QTest::qExec(&test, argc + 1, arguments.data());
}

RegisteredTest::RegisteredTest(const char* name, TestRun run)
{
    runs().emplace(name, run);
}

} // namespace test

int main(int argc, char** argv)
{
    const auto found = argc > 1 ? test::runs().find(argv[1]) : test::runs().end();
    if (found == test::runs().end()) {
        std::fprintf(stderr, "usage: %s TEST [FUNCTION[:ROW]...] [options of Qt Test]\n", argv[0]);
        for (const auto& [name, run] : test::runs())
            std::fprintf(stderr, "  %s\n", name.c_str());
        return 2;
    }
    test::shareCompiledShaders();
    std::vector<char*> arguments(argv, argv + argc);
    arguments.erase(arguments.begin() + 1);
    arguments.push_back(nullptr);
    return found->second(argc - 1, arguments.data());
}
