// SPDX-License-Identifier: Apache-2.0
#include "core/fence/FencedDecoder.h"
#include "core/fence/FenceProtocol.h"
#include "tests/support/program/Sanitizer.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <thread>

#include <ctime>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

namespace fencedDecoderTest {

using namespace core;
using Bytes = std::vector<std::uint8_t>;
using Outcome = WorkerProcess::Outcome;
using std::chrono::milliseconds;

namespace {

constexpr const char* misbehave = "--misbehave";
constexpr const char* babble = "--babble";

Bytes bytesOf(std::string_view text)
{
    return {text.begin(), text.end()};
}

/// Keeps a compiler from seeing that something is of no use.
volatile std::uint64_t sink = 0;

void spinSeconds(int seconds)
{
    timespec begin{};
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &begin);
    do
        clock_gettime(CLOCK_MONOTONIC, &now);
    while (now.tv_sec - begin.tv_sec < seconds);
}

/// What a decoder does that somebody has taken over, or that is broken: as the parameters say.
QString misbehaved(std::span<const std::uint8_t> parameters, std::span<const std::uint8_t> input,
    std::span<std::uint8_t> output)
{
    const std::string_view what(
        reinterpret_cast<const char*>(parameters.data()), parameters.size());
    if (what == "hang") {
        while (true)
            sink = sink + 1;
    } else if (what == "spin") {
        spinSeconds(2);
    } else if (what == "crash") {
        raise(SIGSEGV);
    } else if (what == "abort") {
        std::abort();
    } else if (what == "allocate") {
        std::vector<Bytes> all;
        while (true)
            all.emplace_back(std::size_t(16) << 20, std::uint8_t(1));
    } else if (what == "open") {
        sink = std::uint64_t(open("/etc/hostname", O_RDONLY));
    } else if (what == "create") {
        sink = std::uint64_t(open("/tmp/burin-fence-test", O_WRONLY | O_CREAT, 0600));
    } else if (what == "socket") {
        sink = std::uint64_t(socket(AF_INET, SOCK_STREAM, 0));
    } else if (what == "fork") {
        sink = std::uint64_t(fork());
    } else if (what == "exec") {
        execl("/bin/true", "true", nullptr);
    } else if (what == "kill") {
        kill(getppid(), SIGTERM);
    } else if (what == "code") {
        sink = std::uint64_t(reinterpret_cast<std::uintptr_t>(mmap(nullptr, 4096,
            PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)));
    } else if (what == "write elsewhere") {
        sink = std::uint64_t(write(2, "x", 1));
    } else if (what == "throw") {
        throw std::runtime_error("thrown in a decoder");
    } else if (what == "throw nothing") {
        throw std::runtime_error("");
    } else if (what == "refuse") {
        return QStringLiteral("refused\nwith\u2028a \x01\u2029line");
    } else if (what == "chatter") {
        return QString(5000, QLatin1Char('x'));
    }
    std::reverse_copy(input.begin(), input.end(), output.begin());
    return {};
}

/// A decoder that does not keep to the protocol.
int babbleOn(std::string_view how)
{
    const int socket = fence::socketDescriptor;
    if (how == "at once") {
        sink = std::uint64_t(write(socket, "garbage", 7));
        pause();
    }
    const fence::Ready ready{.filtered = 1};
    sink = std::uint64_t(write(socket, &ready, sizeof(ready)));
    if (how == "unasked")
        sink = std::uint64_t(write(socket, &ready, sizeof(ready)));
    fence::Request request;
    if (read(socket, &request, sizeof(request)) != ssize_t(sizeof(request)))
        return 1;
    fence::Reply reply{.number = request.number, .verdict = fence::Verdict::Done};
    std::size_t size = sizeof(reply);
    if (how == "magic")
        reply.magic = 7;
    else if (how == "number")
        reply.number = request.number + 1;
    else if (how == "verdict")
        reply.verdict = fence::Verdict(77);
    else if (how == "sentence")
        reply.sentenceBytes = 0xffffffffu;
    else if (how == "short")
        size = 9;
    else if (how == "nothing")
        size = 0;
    else if (how == "cut memory")
        sink = std::uint64_t(ftruncate(fence::memoryDescriptor, 0));
    Bytes message(sizeof(reply) + 4096, 0xa5);
    std::memcpy(message.data(), &reply, sizeof(reply));
    if (how == "long")
        size = message.size();
    sink = std::uint64_t(write(socket, message.data(), size));
    pause();
    return 0;
}

WorkerProgram selfAs(const char* option, const char* how = "")
{
    return {.path = QStringLiteral("/proc/self/exe"),
        .arguments = {QStringLiteral("FencedDecoderTest"), QString::fromLatin1(option),
            QString::fromLatin1(how)}};
}

/// Processes that this one started and that are there.
std::vector<pid_t> childProcesses()
{
    std::vector<pid_t> all;
    const QString own = QStringLiteral("PPid:\t%1\n").arg(getpid());
    for (const QString& name : QDir(QStringLiteral("/proc")).entryList(QDir::Dirs)) {
        QFile status(QStringLiteral("/proc/%1/status").arg(name));
        if (name.toInt() <= 0 || !status.open(QIODevice::ReadOnly))
            continue;
        const QString text = QString::fromLatin1(status.readAll());
        if (text.contains(own) && !text.contains(QLatin1String("State:\tZ")))
            all.push_back(name.toInt());
    }
    return all;
}

struct Decoded {
    QString wrong;
    Bytes output;
};

Decoded decoded(FencedDecoder& decoder, std::string_view how, const Bytes& input = bytesOf("abc"))
{
    Decoded result;
    const Bytes parameters = bytesOf(how);
    result.wrong =
        decoder.decode(parameters, input, input.size(), [&](std::span<const std::uint8_t> output) {
            result.output.assign(output.begin(), output.end());
        });
    return result;
}

} // namespace

/// Decoders that hang, crash, reach for what is not theirs or lie.
class FencedDecoderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void worksAgainAndAgain();
    void largeFramesGrowTheMemory();
    void failuresCostOneCall_data();
    void failuresCostOneCall();
    void systemCallsAreStopped_data();
    void systemCallsAreStopped();
    void sentencesAreOnePrintableLine();
    void hangingIsStopped();
    void killedInTheMiddleIsReplaced();
    void killedAgainAndAgainIsSaid();
    void killedWhileWaitingIsReplaced();
    void garbageIsNoAnswer_data();
    void garbageIsNoAnswer();
    void withoutAProgramNothingIsDecoded();
    void nothingIsLeftBehind();
    void manyThreadsShareThem();
    void insideWorksTheSame();
};

void FencedDecoderTest::worksAgainAndAgain()
{
    FencedDecoder decoder;
    decoder.setProgram(selfAs(misbehave));
    for (int round = 0; round < 100; ++round) {
        const Bytes input = bytesOf(QByteArray::number(round).toStdString());
        const Decoded result = decoded(decoder, "", input);
        QCOMPARE(result.wrong, QString());
        QVERIFY(result.output == Bytes(input.rbegin(), input.rend()));
    }
    QCOMPARE(decoder.idle().size(), std::size_t(1));
}

void FencedDecoderTest::largeFramesGrowTheMemory()
{
    FencedDecoder decoder;
    decoder.setProgram(selfAs(misbehave));
    for (const std::size_t size : {1u, 4096u, 4097u, 5u << 20, 300u, 40u << 20}) {
        Bytes input(size);
        for (std::size_t at = 0; at < size; ++at)
            input[at] = std::uint8_t(at * 7 + at / 251);
        const Decoded result = decoded(decoder, "", input);
        QCOMPARE(result.wrong, QString());
        QVERIFY(result.output == Bytes(input.rbegin(), input.rend()));
    }
    // One that has so much does not keep it while it waits.
    QVERIFY(decoder.idle().empty());
}

void FencedDecoderTest::failuresCostOneCall_data()
{
    QTest::addColumn<QByteArray>("how");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* how, const char* sentence) {
        QTest::newRow(how) << QByteArray(how) << QString::fromLatin1(sentence);
    };
    row("crash", "the decoder stopped");
    row("abort", "the decoder stopped");
    // The sanitizer ends a program that asks for more memory than it may have.
    if (!test::underSanitizer)
        row("allocate", "decoding it takes more memory than such an image may");
    // That sanitizer reads a file when something is thrown, and the fence lets nobody read.
    if (!test::underAddressSanitizer) {
        row("throw", "thrown in a decoder");
        row("throw nothing", "damaged pixel data");
    }
}

void FencedDecoderTest::failuresCostOneCall()
{
    QFETCH(QByteArray, how);
    QFETCH(QString, sentence);
    FencedDecoder decoder;
    decoder.setProgram(selfAs(misbehave));
    QCOMPARE(decoded(decoder, "").wrong, QString());
    QCOMPARE(decoded(decoder, how.toStdString()).wrong, sentence);
    QCOMPARE(decoded(decoder, "").output, bytesOf("cba"));
}

void FencedDecoderTest::systemCallsAreStopped_data()
{
    QTest::addColumn<QByteArray>("how");
    for (const char* how :
        {"open", "create", "socket", "fork", "exec", "kill", "code", "write elsewhere"})
        QTest::newRow(how) << QByteArray(how);
}

void FencedDecoderTest::systemCallsAreStopped()
{
    QFETCH(QByteArray, how);
    core::Clause why;
    const auto worker = WorkerProcess::start(selfAs(misbehave), milliseconds(10000), why);
    QVERIFY2(worker, qPrintable(why));
    if (!worker->isFiltered())
        QSKIP("this kernel filters no system calls");
    const Bytes input = bytesOf("abc");
    // Refused by a limit alone it would go on and answer.
    const auto answer =
        worker->ask(bytesOf(how.toStdString()), input, input.size(), milliseconds(10000));
    QCOMPARE(answer.outcome, Outcome::Stopped);
    QVERIFY(!QFile::exists(QStringLiteral("/tmp/burin-fence-test")));
}

void FencedDecoderTest::sentencesAreOnePrintableLine()
{
    FencedDecoder decoder;
    decoder.setProgram(selfAs(misbehave));
    QCOMPARE(decoded(decoder, "refuse").wrong, QStringLiteral("refused?with?a ??line"));
    QCOMPARE(decoded(decoder, "chatter").wrong.size(), qsizetype(fence::longestSentence));
    QCOMPARE(decoder.idle().size(), std::size_t(1));
}

void FencedDecoderTest::hangingIsStopped()
{
    FencedDecoder decoder;
    decoder.setProgram(selfAs(misbehave));
    decoder.setPatience(milliseconds(300));
    QCOMPARE(decoded(decoder, "hang").wrong,
        QStringLiteral("the decoder took too long and was stopped"));
    QVERIFY(childProcesses().empty());
    decoder.setPatience(milliseconds(9000));
    QCOMPARE(decoded(decoder, "").output, bytesOf("cba"));
}

void FencedDecoderTest::killedInTheMiddleIsReplaced()
{
    FencedDecoder decoder;
    decoder.setProgram(selfAs(misbehave));
    QCOMPARE(decoded(decoder, "").wrong, QString());
    const pid_t first = decoder.idle().front();
    Decoded result;
    std::thread thread([&] { result = decoded(decoder, "spin"); });
    while (!decoder.idle().empty())
        std::this_thread::yield();
    kill(first, SIGKILL);
    thread.join();
    QCOMPARE(result.wrong, QString());
    QCOMPARE(result.output, bytesOf("cba"));
    QVERIFY(decoder.idle().front() != first);
}

void FencedDecoderTest::killedAgainAndAgainIsSaid()
{
    FencedDecoder decoder;
    decoder.setProgram(selfAs(misbehave));
    std::atomic<bool> done = false;
    Decoded result;
    std::thread thread([&] {
        result = decoded(decoder, "hang");
        done = true;
    });
    // Those that are still on their way to their own main() are left alone.
    while (!done) {
        std::this_thread::sleep_for(milliseconds(200));
        for (const pid_t child : childProcesses())
            kill(child, SIGKILL);
    }
    thread.join();
    QVERIFY2(result.wrong == QStringLiteral("the decoder stopped")
            || result.wrong.startsWith(QStringLiteral("the decoder cannot be started")),
        qPrintable(result.wrong));
}

void FencedDecoderTest::killedWhileWaitingIsReplaced()
{
    FencedDecoder decoder;
    decoder.setProgram(selfAs(misbehave));
    QCOMPARE(decoded(decoder, "").wrong, QString());
    for (const pid_t waiting : decoder.idle())
        kill(waiting, SIGKILL);
    QCOMPARE(decoded(decoder, "").output, bytesOf("cba"));
}

void FencedDecoderTest::garbageIsNoAnswer_data()
{
    QTest::addColumn<QByteArray>("how");
    QTest::addColumn<bool>("isAnswer");
    for (const char* how : {"magic", "number", "verdict", "sentence", "short", "long"})
        QTest::newRow(how) << QByteArray(how) << false;
    // What it may not do does not hurt: the memory stays as long as it is.
    QTest::newRow("cut memory") << QByteArray("cut memory") << true;
}

void FencedDecoderTest::garbageIsNoAnswer()
{
    QFETCH(QByteArray, how);
    QFETCH(bool, isAnswer);
    FencedDecoder decoder;
    decoder.setProgram(selfAs(babble, how.constData()));
    const Decoded result = decoded(decoder, "");
    QCOMPARE(result.wrong,
        isAnswer ? QString() : QStringLiteral("the decoder answered nonsense and was stopped"));
    QCOMPARE(decoder.idle().size(), std::size_t(isAnswer ? 1 : 0));
    QCOMPARE(childProcesses().size(), std::size_t(isAnswer ? 1 : 0));
}

void FencedDecoderTest::withoutAProgramNothingIsDecoded()
{
    FencedDecoder decoder;
    const auto complaint = [&] { return decoded(decoder, "").wrong; };
    QCOMPARE(complaint(),
        QStringLiteral("the decoder cannot be started: nothing says which program it is"));
    decoder.setProgram({.path = QStringLiteral("/no/such/program"), .arguments = {}});
    QCOMPARE(
        complaint(), QStringLiteral("the decoder cannot be started: No such file or directory"));
    decoder.setProgram({.path = QStringLiteral("/bin/true"), .arguments = {}});
    QCOMPARE(complaint(), QStringLiteral("the decoder cannot be started: it is not Burin's"));
    decoder.setProgram(selfAs(babble, "at once"));
    QCOMPARE(complaint(), QStringLiteral("the decoder cannot be started: it is not Burin's"));
    QVERIFY(childProcesses().empty());
}

void FencedDecoderTest::nothingIsLeftBehind()
{
    {
        FencedDecoder decoder;
        decoder.setProgram(selfAs(misbehave));
        QCOMPARE(decoded(decoder, "").wrong, QString());
        QCOMPARE(childProcesses().size(), std::size_t(1));
    }
    QVERIFY(childProcesses().empty());
}

void FencedDecoderTest::manyThreadsShareThem()
{
    FencedDecoder decoder;
    decoder.setProgram(selfAs(misbehave));
    std::atomic<int> good = 0;
    std::atomic<int> bad = 0;
    std::vector<std::thread> threads;
    for (int number = 0; number < 6; ++number) {
        threads.emplace_back([&decoder, &good, &bad, number] {
            for (int round = 0; round < 20; ++round) {
                const bool crash = (number + round) % 7 == 0;
                const Decoded result = decoded(decoder, crash ? "crash" : "");
                good += result.output == bytesOf("cba") ? 1 : 0;
                bad += result.wrong == QStringLiteral("the decoder stopped") ? 1 : 0;
            }
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    QCOMPARE(good + bad, 120);
    QVERIFY(bad >= 15 && bad <= 20);
    QVERIFY(decoder.idle().size() <= std::max(1u, std::thread::hardware_concurrency()));
}

void FencedDecoderTest::insideWorksTheSame()
{
    FencedDecoder decoder;
    decoder.decodeInside(misbehaved);
    QCOMPARE(decoded(decoder, "").output, bytesOf("cba"));
    QVERIFY(childProcesses().empty());
}

namespace {

int runFencedDecoder(int argc, char** argv)
{
    if (argc == 3 && std::strcmp(argv[1], misbehave) == 0)
        return runDecodeWorker([] {}, misbehaved);
    if (argc == 3 && std::strcmp(argv[1], babble) == 0)
        return babbleOn(argv[2]);
    return test::runTest<FencedDecoderTest, QCoreApplication>(argc, argv);
}

} // namespace

BURIN_TEST_RUN(FencedDecoderTest, runFencedDecoder)

} // namespace fencedDecoderTest

#include "FencedDecoderTest.moc"
