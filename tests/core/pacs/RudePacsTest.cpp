// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/PacsQuery.h"
#include "core/pacs/PacsSend.h"
#include "core/pacs/retrieve/PacsRetrieve.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/PacsServers.h"
#include "tests/support/servers/RudeServer.h"
#include "ui/base/ErrorText.h"

#include <QDir>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace rudePacsTest {

using core::ErrorCode;
using Client = test::RudeServer::Client;
using Talk = std::function<void(const Client&)>;

} // namespace rudePacsTest

Q_DECLARE_METATYPE(rudePacsTest::Talk)

namespace rudePacsTest {

namespace {

QByteArray garbage(int size)
{
    QByteArray bytes;
    for (int i = 0; i < size; ++i)
        bytes.append(char((quint32(i) * 7919U + quint32(i) / 251U) & 0xffU));
    return bytes;
}

/// The head of a message of DICOM's upper layer (PS3.8 9.3.1).
QByteArray head(char type, std::uint32_t size)
{
    QByteArray bytes(2, '\0');
    bytes[0] = type;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.append(char((size >> shift) & 0xffU));
    return bytes;
}

/// The answer that accepts whatever was proposed: the request itself, with other types of items and
/// in each context one transfer syntax (PS3.8 9.3.3).
QByteArray accepted(const QByteArray& request)
{
    QByteArray fixed = request.mid(6, 68);
    QByteArray items;
    for (qsizetype at = 74; at + 4 <= request.size();) {
        const int size = (std::uint8_t(request[at + 2]) << 8) | std::uint8_t(request[at + 3]);
        QByteArray item = request.mid(at, 4 + size);
        at += 4 + size;
        if (item[0] == 0x20) {
            // Number, result, then what is the first transfer syntax behind the abstract one.
            const int skipped = (std::uint8_t(item[10]) << 8) | std::uint8_t(item[11]);
            QByteArray syntax = item.mid(12 + skipped);
            const int length = (std::uint8_t(syntax[2]) << 8) | std::uint8_t(syntax[3]);
            syntax = syntax.left(4 + length);
            QByteArray answer = item.mid(4, 4);
            answer[2] = 0;
            answer += syntax;
            item = QByteArray(4, '\0') + answer;
            item[0] = 0x21;
            item[2] = char((answer.size() >> 8) & 0xff);
            item[3] = char(answer.size() & 0xff);
        }
        items += item;
    }
    return head(2, std::uint32_t(fixed.size() + items.size())) + fixed + items;
}

constexpr char isCommand = 3; ///< and the last part of it
constexpr char isData = 2; ///< likewise

/// One message part with a set in it (PS3.8 9.3.5), of context 1.
QByteArray message(char kind, const QByteArray& set)
{
    const QByteArray part = QByteArray(1, char(1)) + QByteArray(1, kind) + set;
    QByteArray value;
    for (int shift = 24; shift >= 0; shift -= 8)
        value.append(char((std::uint32_t(part.size()) >> shift) & 0xffU));
    value += part;
    return head(4, std::uint32_t(value.size())) + value;
}

QByteArray element(std::uint16_t number, const QByteArray& value)
{
    QByteArray bytes(8, '\0');
    bytes[2] = char(number & 0xff);
    bytes[3] = char(number >> 8);
    bytes[4] = char(value.size());
    return bytes + value;
}

QByteArray word(std::uint16_t value)
{
    return QByteArray(1, char(value & 0xff)) + QByteArray(1, char(value >> 8));
}

constexpr std::uint16_t atWork = 0xff00; ///< the status "pending"

/// A response to C-GET, C-MOVE or C-FIND with this status, whose data follow if it has some.
QByteArray response(std::uint16_t field, const QByteArray& classUid, std::uint16_t status,
    const QByteArray& data = {})
{
    const std::uint16_t dataType = data.isEmpty() ? 0x0101 : 1;
    QByteArray uid = classUid;
    if (uid.size() % 2 != 0)
        uid.append('\0');
    const QByteArray rest = element(0x0002, uid) + element(0x0100, word(field))
        + element(0x0120, word(1)) + element(0x0800, word(dataType))
        + element(0x0900, word(status));
    QByteArray size(4, '\0');
    size[0] = char(rest.size() & 0xff);
    const QByteArray said = message(isCommand, element(0x0000, size) + rest);
    return data.isEmpty() ? said : said + message(isData, data);
}

/// The answer to a search for series: one, in Explicit VR Little Endian.
QByteArray seriesFound(QByteArray uid)
{
    if (uid.size() % 2 != 0)
        uid.append('\0');
    return QByteArray("\x08\x00\x52\x00"
                      "CS\x06\x00"
                      "SERIES"
                      "\x20\x00\x0e\x00"
                      "UI",
               20)
        + word(std::uint16_t(uid.size())) + uid;
}

/// What the client says until it has named the level of what it asks for.
QByteArray heardRequest(const Client& client)
{
    QByteArray all;
    while (!all.contains("SERIES") && !all.contains("IMAGE")) {
        const QByteArray more = client.hear();
        if (more.isEmpty())
            break;
        all += more;
    }
    return all;
}

const QByteArray findModel = "1.2.840.10008.5.1.4.1.2.2.1";
const QByteArray moveModel = "1.2.840.10008.5.1.4.1.2.2.2";

} // namespace

/// What machines can do that keep to no protocol, or to all of it but its end: they are given up in
/// time, and nothing grows meanwhile.
class RudePacsTest : public QObject {
    Q_OBJECT

    static constexpr int timeout = 1;
    static constexpr int longest = 20'000; ///< ms; a hang lasts for minutes

    static core::PacsNode node(const test::RudeServer& server, int seconds = timeout)
    {
        return {.aeTitle = QStringLiteral("RUDE"),
            .host = QStringLiteral("127.0.0.1"),
            .port = server.port(),
            .timeoutSeconds = seconds,
            .tls = {}};
    }

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void echoes_data();
    void echoes();
    void searches_data();
    void searches();
    void imagesThatNobodyLists();
    void handshakes();
    void downloadsThatNeverCome();
    void slowDownloadsComeThrough();
    void movesWithoutAWord();
};

void RudePacsTest::echoes_data()
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
    const QList<ErrorCode> broken{ErrorCode::NodeNonsense, ErrorCode::NodeLost};
    row(
        "says nothing", [](const Client& client) { client.beSilent(); }, late);
    row(
        "drips an answer without end",
        [](const Client& client) {
            client.hear();
            client.drip(head(2, 0x1000) + QByteArray(0x1000, '\0'), 100);
        },
        late);
    row(
        "drips garbage", [](const Client& client) { client.drip(garbage(2000), 100); },
        broken + late);
    row(
        "accepts, and drips the answer",
        [](const Client& client) {
            client.say(accepted(client.hear()));
            client.hear();
            client.drip(head(4, 0x1000) + QByteArray(0x1000, '\0'), 100);
        },
        late);
    row(
        "accepts, and says nothing",
        [](const Client& client) {
            client.say(accepted(client.hear()));
            client.beSilent();
        },
        late);
    row(
        "garbage",
        [](const Client& client) {
            client.say(garbage(4096));
            client.beSilent();
        },
        broken + late);
    row(
        "floods", [](const Client& client) { client.flood(garbage(1 << 20), 2000); }, broken);
    row(
        "tears the connection", [](const Client& client) { client.reset(); }, broken);
    row(
        "hangs up", [](const Client&) {}, broken);
    row(
        "says that it says 4 GB",
        [](const Client& client) {
            client.hear();
            client.say(head(2, 0xffffffff));
            client.flood(QByteArray(1 << 20, '\0'), 2000);
        },
        broken);
    row(
        "accepts, and says that it says 4 GB",
        [](const Client& client) {
            client.say(accepted(client.hear()));
            client.hear();
            client.say(head(4, 0xffffffff));
            client.flood(QByteArray(1 << 20, '\0'), 2000);
        },
        broken);
}

void RudePacsTest::echoes()
{
    QFETCH(Talk, talk);
    QFETCH(QList<int>, expected);
    const test::RudeServer server(talk);
    QElapsedTimer clock;
    clock.start();
    const auto answered = core::echoNode(node(server), core::Progress());
    QVERIFY2(clock.elapsed() < longest, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(!answered);
    QVERIFY2(
        expected.contains(int(answered.error().code)), qPrintable(ui::errorText(answered.error())));
    QVERIFY(ui::errorText(answered.error()).startsWith(QLatin1String("RUDE@127.0.0.1:")));
}

void RudePacsTest::searches_data()
{
    QTest::addColumn<Talk>("talk");
    QTest::newRow("is at work for ever") << Talk([](const Client& client) {
        client.say(accepted(client.hear()));
        client.hear();
        const QByteArray again = response(0x8020, findModel, atWork);
        while (client.say(again))
            QTest::qSleep(200);
    });
    QTest::newRow("drips an answer") << Talk([](const Client& client) {
        client.say(accepted(client.hear()));
        client.hear();
        client.drip(response(0x8020, findModel, atWork), 300);
        client.beSilent();
    });
}

void RudePacsTest::searches()
{
    QFETCH(Talk, talk);
    const test::RudeServer server(talk);
    QElapsedTimer clock;
    clock.start();
    const auto found = core::findStudies(node(server), {}, 10, core::Progress());
    QVERIFY2(clock.elapsed() < longest, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(!found);
    QVERIFY2(found.error().code == ErrorCode::NodeTimeout
            || found.error().code == ErrorCode::NodeNonsense,
        qPrintable(ui::errorText(found.error())));
}

/// Nodes may not support the search for images: what they hold is not known then, and that is no
/// error.
void RudePacsTest::imagesThatNobodyLists()
{
    const test::RudeServer server([](const Client& client) {
        client.say(accepted(client.hear()));
        client.hear();
        client.say(response(0x8020, findModel, 0xa900));
        client.beSilent();
    });
    const auto found = core::findInstances(
        node(server), QStringLiteral("2.25.1"), QStringLiteral("2.25.2"), core::Progress());
    VERIFY_DONE(found);
    QVERIFY(found->empty());
    // Of studies it is one.
    const auto studies = core::findStudies(node(server), {}, 10, core::Progress());
    VERIFY_ERROR(studies, ErrorCode::NodeFailed);
}

/// Inside of TLS nobody asks on the way.
void RudePacsTest::handshakes()
{
    const QTemporaryDir folder;
    const test::TlsFiles files = test::TlsFiles::make(folder.path());
    if (files.serverCertificate.isEmpty())
        QSKIP("openssl is not installed");
    const test::RudeServer server([](const Client& client) {
        client.hear();
        // A record of 16 KiB, in which the server says hello.
        client.drip(QByteArray("\x16\x03\x03\x40\x00", 5) + QByteArray(0x4000, '\2'), 100);
    });
    core::PacsNode rude = node(server);
    rude.tls.authorityFile = files.serverCertificate;
    QElapsedTimer clock;
    clock.start();
    const auto answered = core::echoNode(rude, core::Progress());
    QVERIFY2(clock.elapsed() < longest, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(!answered);
    QVERIFY2(answered.error().code == ErrorCode::NodeTimeout
            || answered.error().code == ErrorCode::NodeUnreachable,
        qPrintable(ui::errorText(answered.error())));
}

void RudePacsTest::downloadsThatNeverCome()
{
    test::PacsServer holds(test::PacsServer::Program::Dcmqrscp);
    if (!holds.absent().isEmpty())
        QSKIP(qPrintable(holds.absent()));
    const QTemporaryDir folder;
    test::SyntheticSeries series;
    series.size = {64, 64, 4};
    const QStringList files = test::writeSeries(series, folder.filePath(QStringLiteral("sent")));
    VERIFY_DONE(core::sendFiles(holds.node(), files, core::Progress()));
    for (const std::int64_t after : {0, 400, 12'000}) {
        const test::FaultyWire wire(holds.node().port, test::FaultyWire::Fault::Drip, after);
        core::PacsNode dripping = holds.node();
        dripping.port = wire.port();
        dripping.timeoutSeconds = 2;
        const QString target = folder.filePath(QStringLiteral("got"));
        QElapsedTimer clock;
        clock.start();
        const auto got = core::retrieve(
            dripping, {.studyUid = series.studyUid, .seriesUid = {}}, target, {}, core::Progress());
        QVERIFY2(clock.elapsed() < longest, qPrintable(QString::number(clock.elapsed())));
        VERIFY_ERROR(got, ErrorCode::NodeTimeout);
        QVERIFY(!QFileInfo::exists(target));
    }
}

/// What comes slowly and comes is no drip: four kilobytes a second, and silence of less than the
/// timeout between.
void RudePacsTest::slowDownloadsComeThrough()
{
    test::PacsServer holds(test::PacsServer::Program::Dcmqrscp);
    if (!holds.absent().isEmpty())
        QSKIP(qPrintable(holds.absent()));
    const QTemporaryDir folder;
    test::SyntheticSeries series;
    series.size = {64, 64, 2};
    const QStringList files = test::writeSeries(series, folder.filePath(QStringLiteral("sent")));
    VERIFY_DONE(core::sendFiles(holds.node(), files, core::Progress()));
    const test::FaultyWire wire(holds.node().port, test::FaultyWire::Fault::Slow, 1000);
    core::PacsNode slow = holds.node();
    slow.port = wire.port();
    slow.timeoutSeconds = 2;
    const auto got = core::retrieve(slow, {.studyUid = series.studyUid, .seriesUid = {}},
        folder.filePath(QStringLiteral("got")), {}, core::Progress());
    VERIFY_DONE(got);
    QCOMPARE(got->received, 2);
}

/// A node need not say that it is at work on a move. While objects come it is not silent, on the
/// other connection.
void RudePacsTest::movesWithoutAWord()
{
    const QTemporaryDir folder;
    test::SyntheticSeries series;
    series.size = {64, 64, 8};
    const QStringList files = test::writeSeries(series, folder.filePath(QStringLiteral("sent")));
    const int movePort = test::freePort();
    QStringList troubles; // of the server's thread; read when it has ended
    auto server = std::make_unique<test::RudeServer>([&](const Client& client) {
        const QByteArray proposal = client.hear();
        const bool isMove = proposal.contains(moveModel);
        client.say(accepted(proposal));
        const QByteArray request = heardRequest(client);
        if (isMove) {
            const core::PacsNode us{.aeTitle = QStringLiteral("BURIN"),
                .host = QStringLiteral("127.0.0.1"),
                .port = movePort,
                .ownAeTitle = QStringLiteral("RUDE"),
                .timeoutSeconds = 20,
                .tls = {}};
            for (const QString& file : files) {
                QTest::qSleep(1000);
                const auto sent = core::sendFiles(us, {file}, core::Progress());
                if (!sent)
                    troubles += ui::errorText(sent.error());
            }
            client.say(response(0x8021, moveModel, 0));
        } else if (request.contains("IMAGE")) {
            client.say(response(0x8020, findModel, 0xa900));
        } else {
            client.say(response(0x8020, findModel, atWork, seriesFound(series.seriesUid.toLatin1()))
                + response(0x8020, findModel, 0));
        }
        client.hear();
    });
    const auto got =
        core::retrieve(node(*server, 6), {.studyUid = series.studyUid, .seriesUid = {}},
            folder.filePath(QStringLiteral("got")), {.movePort = movePort}, core::Progress());
    server.reset();
    QCOMPARE(troubles, QStringList());
    VERIFY_DONE(got);
    QCOMPARE(got->received, 8);
}

BURIN_TEST(RudePacsTest)

} // namespace rudePacsTest

#include "RudePacsTest.moc"
