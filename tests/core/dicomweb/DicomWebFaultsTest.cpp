// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebConnection.h"
#include "core/dicomweb/WebQuery.h"
#include "core/dicomweb/WebRetrieve.h"
#include "core/dicomweb/WebSend.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/faults/SmallFileSystem.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/PacsServers.h"
#include "tests/support/servers/WebArchive.h"
#include "ui/base/ErrorText.h"

#include <QDir>
#include <QFileInfo>
#include <QMap>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <thread>

namespace dicomWebFaultsTest {

using core::ErrorCode;
using test::WebReply;

/// What a web server can do wrong: a sentence for each, and nothing half imported.
class DicomWebFaultsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void addressesAreRead();
    void loginsAreRead();
    void nobodyThere();
    void honestServer();
    void lettersAreEncoded();
    void searchAnswers_data();
    void searchAnswers();
    void busyAtFirst();
    void busyForEver();
    void pagesAreTurned();
    void silentServerIsGivenUp();
    void slowServerIsNot();
    void cancelledWhileItWaits();
    void loginGoesNowhereElse();
    void loginIsNotToldPlainly();
    void diesAndGoesOn();
    void diesForEver();
    void answersOfObjects_data();
    void answersOfObjects();
    void unsoundObject();
    void unaskedObjects();
    void fullDisk();
    void storageAnswers_data();
    void storageAnswers();
    void storageIsWhole();

private:
    [[nodiscard]] core::WebNode node(const test::WebServer& server) const;
    [[nodiscard]] QString target() const { return m_folder->filePath(QStringLiteral("got")); }
    [[nodiscard]] core::Result<core::Retrieved> get(
        const core::WebNode& from, const core::Progress& progress = core::Progress()) const
    {
        return core::retrieve(from,
            {.studyUid = m_series.studyUid, .seriesUid = m_series.seriesUid}, target(), progress);
    }
    /// As a sound server answers.
    [[nodiscard]] WebReply sound(const QByteArray& line) const { return m_archive->answer(line); }
    /// Beside the target nothing may be left but what a next download goes on with.
    [[nodiscard]] QStringList leftOver() const
    {
        return QDir(m_folder->path())
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

    QTemporaryDir m_sent;
    test::SyntheticSeries m_series;
    std::optional<test::WebArchive> m_archive;
    QMap<QByteArray, QByteArray> m_objects; ///< by UID
    QStringList m_files;
    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

using test::WebArchive;
const QByteArray multipartType = WebArchive::multipartType;

} // namespace

void DicomWebFaultsTest::initTestCase()
{
    m_series.size = {96, 96, 9};
    m_files = test::writeSeries(m_series, m_sent.path());
    m_archive.emplace(m_files);
    m_objects = m_archive->objects();
    QCOMPARE(m_objects.size(), 9);
}

void DicomWebFaultsTest::init()
{
    test::failOnUnexpectedMessages();
    m_folder = std::make_unique<QTemporaryDir>();
}

core::WebNode DicomWebFaultsTest::node(const test::WebServer& server) const
{
    core::WebNode one;
    one.url = server.url();
    one.firstPauseMs = 10;
    one.timeoutSeconds = 20;
    return one;
}

void DicomWebFaultsTest::addressesAreRead()
{
    const auto web = core::WebNode::parse(QStringLiteral("https://pacs.example/dicom-web/"));
    VERIFY_DONE(web);
    QCOMPARE(web->name(), QStringLiteral("https://pacs.example/dicom-web"));
    for (const char* wrong : {"", "pacs.example/dicom-web", "ftp://a/b", "https://",
             "https://user:secret@pacs/dicom-web", "https://a/b?c=d", "https://a/b#c",
             "https://a b"}) {
        const auto parsed = core::WebNode::parse(QString::fromUtf8(wrong));
        VERIFY_ERROR(parsed, ErrorCode::InvalidField);
        QVERIFY(!ui::errorText(parsed.error()).contains(QLatin1String("secret")));
    }
}

void DicomWebFaultsTest::loginsAreRead()
{
    QCOMPARE(core::WebLogin::parse(QStringLiteral("a:b:c\n"))->header(), "Basic YTpiOmM=");
    QCOMPARE(core::WebLogin::parse(QStringLiteral("bearer x.y.z"))->header(), "Bearer x.y.z");
    for (const char* wrong : {"", "secret", ":secret", "Bearer ", "a:secret\nX-Other: b"}) {
        const auto parsed = core::WebLogin::parse(QString::fromLatin1(wrong));
        VERIFY_ERROR(parsed, ErrorCode::InvalidField);
        QVERIFY(!ui::errorText(parsed.error()).contains(QLatin1String("secret")));
    }
}

void DicomWebFaultsTest::nobodyThere()
{
    core::WebNode nobody;
    nobody.url = QUrl(QStringLiteral("http://127.0.0.1:%1/dicom-web").arg(test::freePort()));
    const auto answered = core::echoNode(nobody, core::Progress());
    VERIFY_ERROR(answered, ErrorCode::NodeUnreachable);
    QCOMPARE(ui::errorText(answered.error()),
        nobody.name() + QStringLiteral(" cannot be reached: Connection refused"));
}

void DicomWebFaultsTest::honestServer()
{
    const test::WebServer server(
        [&](const QByteArray& line, const QByteArray&) { return sound(line); });
    VERIFY_DONE(core::echoNode(node(server), core::Progress()));
    const auto got = get(node(server));
    VERIFY_DONE(got);
    QCOMPARE(got->received, 9);
    QCOMPARE(leftOver(), QStringList{QStringLiteral("got")});
    // One question for all of a series.
    const auto questions = server.questions();
    QCOMPARE(std::count_if(questions.begin(), questions.end(), WebArchive::asksForObjects), 1);
}

void DicomWebFaultsTest::lettersAreEncoded()
{
    const test::WebServer server(
        [&](const QByteArray&, const QByteArray&) { return WebReply{.body = "[]"}; });
    VERIFY_DONE(core::findStudies(node(server),
        {.patientName = QStringLiteral("Mü*"), .patientId = QStringLiteral("A+1 &x=%#?")}, 7,
        core::Progress()));
    const QByteArray line = server.questions().front();
    QVERIFY2(line.startsWith("GET /dicom-web/studies?PatientName=M%C3%BC*&"
                             "PatientID=A%2B1%20%26x%3D%25%23%3F&includefield="),
        line.constData());
    QVERIFY2(line.endsWith("&limit=8&offset=0"), line.constData());
}

void DicomWebFaultsTest::searchAnswers_data()
{
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("type");
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<int>("expected");
    const auto row = [](const char* name, int status, const char* type, const QByteArray& body,
                         ErrorCode expected) {
        QTest::newRow(name) << status << QByteArray(type) << body << int(expected);
    };
    const char* json = "application/dicom+json";
    row("a page for people", 200, "text/html", "<html>welcome</html>", ErrorCode::NodeNonsense);
    row("no JSON", 200, json, "<html>welcome</html>", ErrorCode::NodeNonsense);
    row("half of it", 200, json, "[{\"0020000D\":", ErrorCode::NodeNonsense);
    row("another kind of it", 200, json, "{\"a\":1}", ErrorCode::NodeNonsense);
    row("nested without end", 200, json, QByteArray(1000000, '['), ErrorCode::NodeNonsense);
    row("a login is asked for", 401, json, "", ErrorCode::NodeRejects);
    row("it is forbidden", 403, "text/plain", "no", ErrorCode::NodeRejects);
    row("nothing there", 404, "text/html", "lost?", ErrorCode::NodeHasNone);
    row("a mistake", 500, "text/html", "oops", ErrorCode::NodeFailed);
    row("elsewhere", 302, "text/html", "", ErrorCode::NodeFailed);
}

void DicomWebFaultsTest::searchAnswers()
{
    QFETCH(int, status);
    QFETCH(QByteArray, type);
    QFETCH(QByteArray, body);
    QFETCH(int, expected);
    const test::WebServer server([&](const QByteArray&, const QByteArray&) {
        return WebReply{.status = status, .contentType = type, .body = body};
    });
    const auto found = core::findStudies(
        node(server), {.patientName = QStringLiteral("Geheim*")}, 10, core::Progress());
    VERIFY_ERROR(found, ErrorCode(expected));
    const QString sentence = ui::errorText(found.error());
    QVERIFY2(sentence.startsWith(server.url().toString()), qPrintable(sentence));
    QVERIFY2(!sentence.contains(QLatin1String("Geheim")), qPrintable(sentence));
    QCOMPARE(server.questions().size(), std::size_t(1));
}

void DicomWebFaultsTest::busyAtFirst()
{
    int asked = 0;
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        return ++asked % 3 != 0 ? WebReply{.status = asked % 3 == 1 ? 503 : 429,
                   .contentType = "text/plain",
                   .body = "later",
                   .moreHeaders = "Retry-After: 0\r\n"}
                                : sound(line);
    });
    const auto got = get(node(server));
    VERIFY_DONE(got);
    QCOMPARE(got->received, 9);
}

void DicomWebFaultsTest::busyForEver()
{
    const test::WebServer server([&](const QByteArray&, const QByteArray&) {
        return WebReply{.status = 503, .contentType = "text/plain", .body = "later"};
    });
    const auto found = core::findStudies(node(server), {}, 10, core::Progress());
    VERIFY_ERROR(found, ErrorCode::NodeFailed);
    QVERIFY(ui::errorText(found.error()).contains(QLatin1String("HTTP 503")));
    QCOMPARE(server.questions().size(), std::size_t(4));
}

void DicomWebFaultsTest::pagesAreTurned()
{
    // Three at a time, whatever it is asked for.
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        const int offset = line.mid(line.indexOf("offset=") + 7).toInt();
        QList<QByteArray> entries;
        for (int i = offset; i < std::min(offset + 3, 8); ++i) {
            entries.append(
                "{\"0020000D\":{\"vr\":\"UI\",\"Value\":[\"1.2." + QByteArray::number(i) + "\"]}}");
        }
        return WebReply{.body = "[" + entries.join(',') + "]"};
    });
    const auto all = core::findStudies(node(server), {}, 100, core::Progress());
    VERIFY_DONE(all);
    QCOMPARE(all->hits.size(), std::size_t(8));
    QVERIFY(!all->more);
    const auto some = core::findStudies(node(server), {}, 5, core::Progress());
    VERIFY_DONE(some);
    QCOMPARE(some->hits.size(), std::size_t(5));
    QVERIFY(some->more);
    // One that knows no pages says the same again and again.
    const test::WebServer stubborn([&](const QByteArray&, const QByteArray&) {
        return WebReply{.body = "[{\"0020000D\":{\"vr\":\"UI\",\"Value\":[\"1.2\"]}}]"};
    });
    const auto one = core::findStudies(node(stubborn), {}, 100, core::Progress());
    VERIFY_DONE(one);
    QCOMPARE(one->hits.size(), std::size_t(1));
}

void DicomWebFaultsTest::silentServerIsGivenUp()
{
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        WebReply reply = sound(line);
        reply.afterBytes = WebArchive::asksForObjects(line) ? 50000 : -1;
        reply.fault = WebReply::Fault::Stall;
        return reply;
    });
    core::WebNode silent = node(server);
    silent.timeoutSeconds = 1;
    const auto got = get(silent);
    VERIFY_ERROR(got, ErrorCode::NodeTimeout);
    QVERIFY(!QFileInfo::exists(target()));
}

void DicomWebFaultsTest::slowServerIsNot()
{
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        WebReply reply = sound(line);
        reply.dripMs = WebArchive::asksForObjects(line) ? 10 : 0;
        return reply;
    });
    core::WebNode slow = node(server);
    slow.timeoutSeconds = 1;
    const auto got = get(slow); // takes about two seconds
    VERIFY_DONE(got);
    QCOMPARE(got->received, 9);
}

void DicomWebFaultsTest::cancelledWhileItWaits()
{
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        WebReply reply = sound(line);
        reply.afterBytes = WebArchive::asksForObjects(line) ? 50000 : -1;
        reply.fault = WebReply::Fault::Stall;
        return reply;
    });
    core::WebNode silent = node(server);
    silent.timeoutSeconds = 600;
    core::Progress progress;
    std::thread impatient([&progress] {
        QTest::qSleep(300);
        progress.cancel();
    });
    const auto got = get(silent, progress);
    impatient.join();
    VERIFY_ERROR(got, ErrorCode::Cancelled);
    QVERIFY(!QFileInfo::exists(target()));
    // While it waits before another try, too.
    const test::WebServer busy([&](const QByteArray&, const QByteArray&) {
        return WebReply{.status = 503, .contentType = "text/plain"};
    });
    core::WebNode patient = node(busy);
    patient.firstPauseMs = 600000;
    core::Progress second;
    std::thread again([&second] {
        QTest::qSleep(300);
        second.cancel();
    });
    const auto answered = core::echoNode(patient, second);
    again.join();
    VERIFY_ERROR(answered, ErrorCode::Cancelled);
}

/// Over plain http to another machine everybody on the way would read it; nothing is sent.
void DicomWebFaultsTest::loginIsNotToldPlainly()
{
    using namespace core;
    for (const char* address : {"http://pacs.example.org/dicom-web",
             "http://192.0.2.1:8042/dicom-web", "http://[2001:db8::1]/dicom-web"}) {
        Result<WebNode> node = WebNode::parse(QLatin1String(address));
        QVERIFY(node);
        node->login = {
            .user = QStringLiteral("u"), .password = QStringLiteral("SECRET"), .token = {}};
        const auto refused = WebConnection::open(*node, {});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::InvalidField);
        QVERIFY(refused.error().arguments.join(u' ').contains(u"unencrypted"));
        QVERIFY(!refused.error().arguments.join(u' ').contains(u"SECRET"));
        node->login = {};
        QVERIFY(WebConnection::open(*node, {}));
    }
    for (const char* address : {"http://127.0.0.1:1/w", "http://localhost:1/w", "http://[::1]:1/w",
             "https://pacs.example.org/w"}) {
        Result<WebNode> node = WebNode::parse(QLatin1String(address));
        node->login = {.user = {}, .password = {}, .token = QStringLiteral("t")};
        QVERIFY2(WebConnection::open(*node, {}), address);
    }
    qputenv("BURIN_PLAIN_LOGIN", "yes");
    Result<WebNode> node = WebNode::parse(QStringLiteral("http://pacs.example.org/dicom-web"));
    node->login = {.user = {}, .password = {}, .token = QStringLiteral("t")};
    const bool agreed = bool(WebConnection::open(*node, {}));
    qunsetenv("BURIN_PLAIN_LOGIN");
    QVERIFY(agreed);
}

void DicomWebFaultsTest::loginGoesNowhereElse()
{
    std::atomic<bool> stolen = false;
    const test::WebServer thief([&](const QByteArray&, const QByteArray& question) {
        stolen = stolen || question.toLower().contains("authorization");
        return WebReply{.body = "[]"};
    });
    std::atomic<bool> given = false;
    const test::WebServer server([&](const QByteArray&, const QByteArray& question) {
        given = given || question.contains("Authorization: Basic dGVzdGVyOnNlY3JldA==");
        return WebReply{.status = 307,
            .contentType = "text/plain",
            .moreHeaders = "Location: " + thief.url().toEncoded() + "/studies\r\n"};
    });
    core::WebNode known = node(server);
    known.login = {
        .user = QStringLiteral("tester"), .password = QStringLiteral("secret"), .token = {}};
    const auto answered = core::echoNode(known, core::Progress());
    QVERIFY(!answered.has_value());
    QVERIFY(given);
    QVERIFY(!stolen);
    QVERIFY(thief.questions().empty());
}

void DicomWebFaultsTest::diesAndGoesOn()
{
    // The series breaks off behind three and a half objects; then one by one, of which one dies.
    int asked = 0;
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        WebReply reply = sound(line);
        if (WebArchive::asksForObjects(line)) {
            ++asked;
            reply.afterBytes = asked == 1 ? 70000 : asked == 3 ? 9000 : -1;
        }
        return reply;
    });
    QStringList told;
    const core::Progress progress([&told](core::ProgressStep, int done, int total) {
        told.append(QStringLiteral("%1/%2").arg(done).arg(total));
    });
    const auto got = get(node(server), progress);
    VERIFY_DONE(got);
    QCOMPARE(got->received, 9);
    QCOMPARE(told.back(), QStringLiteral("9/9"));
    QCOMPARE(told.size(), 9);
    // What had come was not asked for again; of the others none was left out.
    const auto questions = server.questions();
    const QList<QByteArray> uids = m_objects.keys();
    for (qsizetype i = 0; i < uids.size(); ++i) {
        const bool isAsked = std::any_of(questions.begin(), questions.end(),
            [&](const QByteArray& line) { return line.endsWith("/instances/" + uids[i]); });
        QCOMPARE(isAsked, i >= 3);
    }
    QCOMPARE(QDir(target()).entryList(QDir::Files | QDir::Hidden).size(), 9);
}

void DicomWebFaultsTest::diesForEver()
{
    const auto dying = [&](const QByteArray& line, const QByteArray&) {
        WebReply reply = sound(line);
        const bool isSeries = line.endsWith(m_series.seriesUid.toLatin1());
        reply.afterBytes = WebArchive::asksForObjects(line) ? (isSeries ? 70000 : 9000) : -1;
        return reply;
    };
    {
        const test::WebServer server(dying);
        VERIFY_ERROR(get(node(server)), ErrorCode::NodeLost);
        QVERIFY(!QFileInfo::exists(target()));
    }
    // Tomorrow it is well.
    const test::WebServer server(
        [&](const QByteArray& line, const QByteArray&) { return sound(line); });
    const auto got = get(node(server));
    VERIFY_DONE(got);
    QCOMPARE(got->kept, 3);
    QCOMPARE(got->received, 6);
    QCOMPARE(leftOver(), QStringList{QStringLiteral("got")});
}

void DicomWebFaultsTest::answersOfObjects_data()
{
    QTest::addColumn<QByteArray>("type");
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<bool>("withoutLength");
    QTest::addColumn<int>("expected");
    QTest::newRow("a page for people")
        << QByteArray("text/html") << QByteArray("<html>") << false << int(ErrorCode::NodeNonsense);
    QTest::newRow("JSON") << QByteArray("application/dicom+json") << QByteArray("[]") << false
                          << int(ErrorCode::NodeNonsense);
    QTest::newRow("no boundary") << QByteArray("multipart/related") << QByteArray("--a-b") << false
                                 << int(ErrorCode::NodeNonsense);
    QTest::newRow("another boundary")
        << QByteArray(multipartType) << "--c\r\n\r\n" + QByteArray(200000, 'x') << false
        << int(ErrorCode::NodeNonsense);
    QTest::newRow("garbage in parts")
        << QByteArray(multipartType)
        << WebArchive::multipart({QByteArray(5000, 'x'), QByteArray("DICM")}) << false
        << int(ErrorCode::TransferIncomplete);
    QTest::newRow("nothing") << QByteArray(multipartType) << QByteArray("--a-b--") << false
                             << int(ErrorCode::TransferIncomplete);
    // Whose end nobody can know but by the boundary.
    QTest::newRow("an end too early") << QByteArray(multipartType) << QByteArray("--a-b\r\n\r\nabc")
                                      << true << int(ErrorCode::NodeLost);
}

void DicomWebFaultsTest::answersOfObjects()
{
    QFETCH(QByteArray, type);
    QFETCH(QByteArray, body);
    QFETCH(bool, withoutLength);
    QFETCH(int, expected);
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        return WebArchive::asksForObjects(line)
            ? WebReply{.contentType = type, .body = body, .withoutLength = withoutLength}
            : sound(line);
    });
    const auto got = get(node(server));
    VERIFY_ERROR(got, ErrorCode(expected));
    QCOMPARE(leftOver(), QStringList());
}

void DicomWebFaultsTest::unsoundObject()
{
    // One of nine is cut short, and its part says nothing of it.
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        if (!WebArchive::asksForObjects(line))
            return sound(line);
        QList<QByteArray> objects = m_objects.values();
        objects[4].chop(500);
        return WebReply{.contentType = multipartType, .body = WebArchive::multipart(objects)};
    });
    const auto got = get(node(server));
    VERIFY_ERROR(got, ErrorCode::TransferIncomplete);
    QVERIFY2(ui::errorText(got.error()).contains(QLatin1String("1 of 9 images did not arrive")),
        qPrintable(ui::errorText(got.error())));
    QVERIFY(!QFileInfo::exists(target()));
}

void DicomWebFaultsTest::unaskedObjects()
{
    test::SyntheticSeries other = m_series;
    other.size = {8, 8, 1};
    other.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_SOPInstanceUID, "2.25.666");
    };
    const QStringList files = test::writeSeries(other, m_folder->filePath(QStringLiteral("other")));
    QFile file(files.front());
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    const auto saying = [&](int often) {
        return [this, bytes, often](const QByteArray& line, const QByteArray&) {
            return WebArchive::asksForObjects(line) ? WebReply{.contentType = multipartType,
                       .body = WebArchive::multipart(
                           QList<QByteArray>(often, bytes) + m_objects.values())}
                                                    : sound(line);
        };
    };
    const test::WebServer tiring(saying(200));
    VERIFY_ERROR(get(node(tiring)), ErrorCode::NodeNonsense);
    const test::WebServer server(saying(1));
    const auto got = get(node(server));
    VERIFY_DONE(got);
    QVERIFY(!QFileInfo::exists(target() + QStringLiteral("/2.25.666.dcm")));
    QCOMPARE(QDir(target()).entryList(QDir::Files | QDir::Hidden).size(), 9);
}

void DicomWebFaultsTest::fullDisk()
{
    const test::WebServer server(
        [&](const QByteArray& line, const QByteArray&) { return sound(line); });
    {
        const test::FileSizeLimit limit(5000);
        VERIFY_ERROR(get(node(server)), ErrorCode::FileUnwritable);
        QCOMPARE(leftOver(), QStringList());
    }
    test::SmallFileSystem disk(100);
    if (!disk.problem().isEmpty())
        QSKIP(qPrintable(disk.problem()));
    const QString folder = disk.filePath(QStringLiteral("got"));
    const core::RetrieveWish wish{.studyUid = m_series.studyUid, .seriesUid = m_series.seriesUid};
    const auto got = core::retrieve(node(server), wish, folder, core::Progress());
    VERIFY_ERROR(got, ErrorCode::FileUnwritable);
    QVERIFY2(got.error().arguments.value(1).contains(QLatin1String("No space left")),
        qPrintable(ui::errorText(got.error())));
    QVERIFY(!QFileInfo::exists(folder));
    disk.resize(1000);
    const auto rest = core::retrieve(node(server), wish, folder, core::Progress());
    VERIFY_DONE(rest);
    QVERIFY(rest->kept > 0);
}

void DicomWebFaultsTest::storageAnswers_data()
{
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<int>("expected");
    QTest::newRow("refused") << 409
                             << QByteArray("{\"00081198\":{\"vr\":\"SQ\",\"Value\":[{\"00081197\":{"
                                           "\"vr\":\"US\",\"Value\":[290]}}]}}")
                             << int(ErrorCode::NodeFailed);
    QTest::newRow("refused amid success")
        << 202
        << QByteArray("{\"00081198\":{\"vr\":\"SQ\",\"Value\":[{\"00081197\":{\"vr\":\"US\","
                      "\"Value\":[290]}}]}}")
        << int(ErrorCode::NodeFailed);
    QTest::newRow("refused without a word") << 409 << QByteArray() << int(ErrorCode::NodeFailed);
    QTest::newRow("forbidden") << 403 << QByteArray() << int(ErrorCode::NodeRejects);
    QTest::newRow("not there") << 404 << QByteArray() << int(ErrorCode::NodeHasNone);
    QTest::newRow("too large") << 413 << QByteArray() << int(ErrorCode::NodeFailed);
}

void DicomWebFaultsTest::storageAnswers()
{
    QFETCH(int, status);
    QFETCH(QByteArray, body);
    QFETCH(int, expected);
    const test::WebServer server([&](const QByteArray&, const QByteArray&) {
        return WebReply{.status = status, .body = body};
    });
    const auto sent = core::sendFiles(node(server), m_files, core::Progress());
    VERIFY_ERROR(sent, ErrorCode(expected));
    if (body.contains("290")) {
        QVERIFY2(ui::errorText(sent.error())
                     .contains(QLatin1String("it does not take this kind of object")),
            qPrintable(ui::errorText(sent.error())));
    }
    QCOMPARE(server.questions().size(), std::size_t(1));
}

void DicomWebFaultsTest::storageIsWhole()
{
    std::atomic<int> whole = 0;
    const test::WebServer server([&](const QByteArray& line, const QByteArray& question) {
        for (const QByteArray& object : m_objects)
            whole += question.contains(object) ? 1 : 0;
        return WebReply{.status = line == "POST /dicom-web/studies" ? 200 : 500,
            .body = "{\"00081199\":{\"vr\":\"SQ\",\"Value\":[{\"00081196\":{\"vr\":\"US\","
                    "\"Value\":[45056]}}]}}"};
    });
    const auto sent = core::sendFiles(node(server), m_files, core::Progress());
    VERIFY_DONE(sent);
    QCOMPARE(sent->sent, 9);
    QCOMPARE(sent->warnings.size(), 9);
    QCOMPARE(int(whole), 9);
}

BURIN_TEST(DicomWebFaultsTest)

} // namespace dicomWebFaultsTest

#include "DicomWebFaultsTest.moc"
