// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebQuery.h"
#include "core/dicomweb/WebRetrieve.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/PacsServers.h"
#include "tests/support/servers/RudeServer.h"
#include "tests/support/servers/WebServer.h"
#include "ui/base/ErrorText.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <zlib.h>

#include <atomic>

namespace rudeWebTest {

using core::ErrorCode;
using test::WebReply;
using Client = test::RudeServer::Client;
using Talk = std::function<void(const Client&)>;

} // namespace rudeWebTest

Q_DECLARE_METATYPE(rudeWebTest::Talk)

namespace rudeWebTest {

namespace {

/// The resident memory of this process, in MiB.
int memoryMib()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    return int(file.readAll().split(' ').value(1).toLongLong() * 4096 >> 20);
}

/// So many bytes of blanks, packed.
QByteArray packedBlanks(int mebibytes)
{
    QByteArray packed(mebibytes * 2048 + 4096, '\0');
    const QByteArray blanks(1 << 20, ' ');
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY);
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = uInt(packed.size());
    for (int i = 0; i <= mebibytes; ++i) {
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(blanks.constData()));
        stream.avail_in = i < mebibytes ? uInt(blanks.size()) : 0;
        deflate(&stream, i < mebibytes ? Z_NO_FLUSH : Z_FINISH);
    }
    packed.truncate(qsizetype(stream.total_out));
    deflateEnd(&stream);
    return packed;
}

const QByteArray goodHead = "HTTP/1.1 200 OK\r\nContent-Type: application/dicom+json\r\n";

} // namespace

/// What web servers can do that keep to no protocol, or lead elsewhere: they are given up in time,
/// memory does not grow by what they say, and nothing is asked of anybody else.
class RudeWebTest : public QObject {
    Q_OBJECT

    static constexpr int longest = 20'000; ///< ms; a hang lasts for minutes

    static core::WebNode node(int port)
    {
        core::WebNode one;
        one.url = QUrl(QStringLiteral("http://127.0.0.1:%1/dicom-web").arg(port));
        one.timeoutSeconds = 2;
        one.retries = 1;
        one.firstPauseMs = 10;
        return one;
    }

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void searches_data();
    void searches();
    void redirections_data();
    void redirections();
    void packedAnswersAreNotUnpacked();
    void pagesWithoutEnd();
    void downloadsDrip();
    void strangersAreNotTrusted();
};

void RudeWebTest::searches_data()
{
    QTest::addColumn<Talk>("talk");
    QTest::addColumn<QList<int>>("expected");
    const auto row = [](const char* name, const Talk& talk, const QList<ErrorCode>& codes) {
        QList<int> numbers;
        for (const ErrorCode code : codes)
            numbers += int(code);
        QTest::newRow(name) << talk << numbers;
    };
    const QList<ErrorCode> late{ErrorCode::NodeTimeout};
    const QList<ErrorCode> broken{ErrorCode::NodeNonsense, ErrorCode::NodeLost,
        ErrorCode::NodeUnreachable, ErrorCode::NodeFailed};
    row(
        "says nothing", [](const Client& client) { client.beSilent(); }, late);
    row(
        "drips its head",
        [](const Client& client) {
            client.hear();
            client.drip(goodHead + QByteArray(10'000, 'a'), 100);
        },
        late);
    row(
        "drips its answer",
        [](const Client& client) {
            client.hear();
            client.say(goodHead + "Content-Length: 100000\r\n\r\n");
            client.drip(QByteArray(100'000, ' '), 100);
        },
        late);
    row(
        "garbage",
        [](const Client& client) {
            client.hear();
            client.say(QByteArray(5000, '\x81'));
        },
        broken);
    row(
        "tears the connection",
        [](const Client& client) {
            client.hear();
            client.reset();
        },
        broken);
    // Whether Qt Network sees this depends on the instant; where it does not, it waits on.
    row(
        "tears the connection at once", [](const Client& client) { client.reset(); },
        broken + late);
    row(
        "ends before its length",
        [](const Client& client) {
            client.hear();
            client.say(goodHead + "Content-Length: 100000\r\n\r\n[]");
        },
        broken);
    row(
        "a length beyond numbers",
        [](const Client& client) {
            client.hear();
            client.say(goodHead + "Content-Length: 99999999999999999999999\r\n\r\n[");
            client.beSilent();
        },
        broken + late);
    row(
        "a negative length",
        [](const Client& client) {
            client.hear();
            client.say(goodHead + "Content-Length: -5\r\n\r\n[");
            client.beSilent();
        },
        broken + late);
    row(
        "an answer without end",
        [](const Client& client) {
            client.hear();
            client.say(goodHead + "Connection: close\r\n\r\n[");
            client.flood(QByteArray(1 << 20, ' '), 4000);
        },
        broken);
    row(
        "a head without end",
        [](const Client& client) {
            client.hear();
            client.say("HTTP/1.1 200 OK\r\n");
            client.flood("X-A: " + QByteArray(1 << 20, 'a') + "\r\n", 4000);
        },
        broken + late);
    row(
        "one line without end",
        [](const Client& client) {
            client.hear();
            client.flood(QByteArray(1 << 20, 'a'), 4000);
        },
        broken + late);
}

void RudeWebTest::searches()
{
    QFETCH(Talk, talk);
    QFETCH(QList<int>, expected);
    const test::RudeServer server(talk);
    const int before = memoryMib();
    QElapsedTimer clock;
    clock.start();
    const auto found = core::findStudies(
        node(server.port()), {.patientName = QStringLiteral("Geheim")}, 10, core::Progress());
    QVERIFY2(clock.elapsed() < longest, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(!found);
    const QString sentence = ui::errorText(found.error());
    QVERIFY2(expected.contains(int(found.error().code)), qPrintable(sentence));
    QVERIFY2(!sentence.contains(QLatin1String("Geheim")), qPrintable(sentence));
    const int grown = memoryMib() - before;
    QVERIFY2(grown < 300, qPrintable(QStringLiteral("%1 MiB more").arg(grown)));
}

void RudeWebTest::redirections_data()
{
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("location");
    for (const int status : {302, 307}) {
        for (const char* location :
            {"file:///etc/passwd", "ftp://127.0.0.1/x", "THIEF", "https://127.0.0.1:1/x",
                "data:application/dicom+json,%5B%5D", "qrc:/x", "", "//", "http://[", "SELF"})
            QTest::addRow("%d %s", status, location) << status << QByteArray(location);
    }
}

/// Elsewhere nothing is asked, read or told, and round in a circle not for ever.
void RudeWebTest::redirections()
{
    QFETCH(int, status);
    QFETCH(QByteArray, location);
    const test::WebServer thief(
        [](const QByteArray&, const QByteArray&) { return WebReply{.body = "[]"}; });
    QByteArray self;
    const test::WebServer server([&](const QByteArray&, const QByteArray&) {
        QByteArray to = location;
        if (location == "THIEF")
            to = thief.url().toEncoded() + "/studies";
        else if (location == "SELF")
            to = self;
        return WebReply{.status = status,
            .contentType = "text/plain",
            .moreHeaders = "Location: " + to + "\r\n"};
    });
    self = server.url().toEncoded() + "/studies";
    core::WebNode led = node(server.url().port());
    led.login = {.user = QStringLiteral("u"), .password = QStringLiteral("SECRET"), .token = {}};
    QElapsedTimer clock;
    clock.start();
    const auto found = core::findStudies(led, {}, 10, core::Progress());
    QVERIFY2(clock.elapsed() < longest, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(!found);
    QVERIFY(thief.questions().empty());
    QVERIFY(!ui::errorText(found.error()).contains(QLatin1String("SECRET")));
}

/// 256 MiB in a quarter of one.
void RudeWebTest::packedAnswersAreNotUnpacked()
{
    const QByteArray bomb = packedBlanks(256);
    QVERIFY(bomb.size() < (1 << 20));
    for (const char* encoding : {"gzip", "deflate", "br", "x-gzip", "gzip, gzip"}) {
        const test::WebServer server([&](const QByteArray&, const QByteArray& question) {
            return WebReply{.status = question.contains("Accept-Encoding: identity") ? 200 : 500,
                .body = bomb,
                .moreHeaders = "Content-Encoding: " + QByteArray(encoding) + "\r\n"};
        });
        const int before = memoryMib();
        const auto found = core::findStudies(node(server.url().port()), {}, 10, core::Progress());
        VERIFY_ERROR(found, ErrorCode::NodeNonsense);
        QVERIFY(memoryMib() - before < 100);
    }
}

/// Every page brings something new, for ever.
void RudeWebTest::pagesWithoutEnd()
{
    std::atomic<int> next = 0;
    const test::WebServer server([&](const QByteArray&, const QByteArray&) {
        QByteArrayList entries;
        for (int i = 0; i < 5000; ++i)
            entries.append("{\"0020000E\":{\"vr\":\"UI\",\"Value\":[\"1.2."
                + QByteArray::number(int(next++)) + "\"]}}");
        return WebReply{.body = "[" + entries.join(',') + "]"};
    });
    core::WebNode endless = node(server.url().port());
    endless.timeoutSeconds = 60;
    const auto found = core::findSeries(endless, QStringLiteral("1.2.3"), core::Progress());
    VERIFY_ERROR(found, ErrorCode::NodeNonsense);
    QVERIFY(next < 200'000);
}

void RudeWebTest::downloadsDrip()
{
    const QTemporaryDir folder;
    const auto found = [](const char* tag) {
        return QByteArray("HTTP/1.1 200 OK\r\nContent-Type: application/dicom+json\r\nConnection: "
                          "close\r\n\r\n[{\"")
            + tag + "\":{\"vr\":\"UI\",\"Value\":[\"1.2.3\"]}}]";
    };
    const test::RudeServer server([&](const Client& client) {
        const QByteArray line = client.hear().split('\r').value(0);
        if (line.contains("/instances?")) {
            client.say(found("00080018"));
        } else if (line.contains("/series?")) {
            client.say(found("0020000E"));
        } else {
            client.say("HTTP/1.1 200 OK\r\nContent-Type: multipart/related; "
                       "type=\"application/dicom\"; boundary=a\r\n\r\n--a\r\n\r\n");
            client.drip(QByteArray(100'000, '\0'), 100);
        }
    });
    QElapsedTimer clock;
    clock.start();
    const auto got =
        core::retrieve(node(server.port()), {.studyUid = QStringLiteral("1.2.3"), .seriesUid = {}},
            folder.filePath(QStringLiteral("got")), core::Progress());
    QVERIFY2(clock.elapsed() < longest, qPrintable(QString::number(clock.elapsed())));
    VERIFY_ERROR(got, ErrorCode::NodeTimeout);
    QVERIFY(QDir(folder.path()).isEmpty());
}

/// A server with a certificate that nobody we know has signed, or of another name; one that speaks
/// no TLS at all.
void RudeWebTest::strangersAreNotTrusted()
{
    const test::WebServer plain(
        [](const QByteArray&, const QByteArray&) { return WebReply{.body = "[]"}; });
    core::WebNode node;
    node.url = plain.url();
    node.url.setScheme(QStringLiteral("https"));
    node.timeoutSeconds = 2;
    node.retries = 0;
    node.login = {.user = QStringLiteral("u"), .password = QStringLiteral("SECRET"), .token = {}};
    QElapsedTimer clock;
    clock.start();
    const auto found = core::findStudies(node, {}, 10, core::Progress());
    QVERIFY(clock.elapsed() < longest);
    QVERIFY(!found);
    QVERIFY(plain.questions().empty());
    const QString sentence = ui::errorText(found.error());
    QVERIFY2(!sentence.contains(QLatin1String("SECRET")), qPrintable(sentence));
}

BURIN_TEST(RudeWebTest)

} // namespace rudeWebTest

#include "RudeWebTest.moc"
