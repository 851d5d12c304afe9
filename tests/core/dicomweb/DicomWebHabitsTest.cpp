// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebQuery.h"
#include "core/dicomweb/WebRetrieve.h"
#include "core/dicomweb/WebSend.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/WebArchive.h"
#include "tests/support/servers/WebServer.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace dicomWebHabitsTest {

using core::ErrorCode;
using test::WebArchive;
using test::WebReply;

/// What web servers of the field do that is no fault of theirs, or a small one: whoever asks them
/// gets all of it nevertheless, or is told what is missing.
class DicomWebHabitsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void unlistedSeries_data();
    void unlistedSeries();
    void listedSeriesThatIsNotThere();
    void seriesWithoutObjects_data();
    void seriesWithoutObjects();
    void storageIsLedToALogin();
    void storageWithoutTheWord_data();
    void storageWithoutTheWord();
    void storageIsNamed();
    void pagesHaveALimit();
    void pagesWithoutAnOffset();
    void listsThatAreCut_data();
    void listsThatAreCut();

private:
    [[nodiscard]] static core::WebNode node(const test::WebServer& server);
    /// As a server answers that holds both series, and lists the objects only of the first.
    [[nodiscard]] WebReply answer(const QByteArray& line, const WebReply& ofUnlisted) const;
    [[nodiscard]] QString target() const { return m_folder->filePath(QStringLiteral("got")); }
    [[nodiscard]] core::Result<core::Retrieved> getStudy(const test::WebServer& server) const
    {
        return core::retrieve(node(server), {.studyUid = m_listed.studyUid, .seriesUid = {}},
            target(), core::Progress());
    }

    QTemporaryDir m_sent;
    test::SyntheticSeries m_listed;
    test::SyntheticSeries m_unlisted;
    QStringList m_files; ///< of the first
    std::optional<WebArchive> m_first;
    std::optional<WebArchive> m_second;
    std::unique_ptr<QTemporaryDir> m_folder;
};

void DicomWebHabitsTest::initTestCase()
{
    m_listed.size = {16, 16, 3};
    m_unlisted.size = {16, 16, 2};
    m_unlisted.seriesUid = QStringLiteral("2.25.815");
    m_files = test::writeSeries(m_listed, m_sent.filePath(QStringLiteral("first")));
    m_first.emplace(m_files);
    m_second.emplace(test::writeSeries(m_unlisted, m_sent.filePath(QStringLiteral("second"))));
}

void DicomWebHabitsTest::init()
{
    test::failOnUnexpectedMessages();
    m_folder = std::make_unique<QTemporaryDir>();
}

core::WebNode DicomWebHabitsTest::node(const test::WebServer& server)
{
    core::WebNode one;
    one.url = server.url();
    one.firstPauseMs = 10;
    one.timeoutSeconds = 20;
    return one;
}

WebReply DicomWebHabitsTest::answer(const QByteArray& line, const WebReply& ofUnlisted) const
{
    const bool isSecond = line.contains(m_unlisted.seriesUid.toLatin1());
    if (isSecond && line.contains("/instances?"))
        return ofUnlisted;
    if (line.contains("/series?") && line.contains("offset=0")) {
        const auto series = [](const QString& uid) {
            return "{\"0020000E\":{\"vr\":\"UI\",\"Value\":[\"" + uid.toLatin1() + "\"]}}";
        };
        return {
            .body = "[" + series(m_listed.seriesUid) + "," + series(m_unlisted.seriesUid) + "]"};
    }
    return (isSecond ? m_second : m_first)->answer(line);
}

void DicomWebHabitsTest::unlistedSeries_data()
{
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("an empty list") << 200 << QByteArray("[]");
    QTest::newRow("nothing") << 204 << QByteArray();
    QTest::newRow("no such page") << 404 << QByteArray();
    QTest::newRow("names that are none")
        << 200 << QByteArray("[{\"00080018\":{\"vr\":\"UI\",\"Value\":[\"no UID\"]}}]");
}

/// Objects of a series may come although none are listed; the other series come as ever.
void DicomWebHabitsTest::unlistedSeries()
{
    QFETCH(int, status);
    QFETCH(QByteArray, body);
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        return answer(line, {.status = status, .body = body});
    });
    const auto got = getStudy(server);
    VERIFY_DONE(got);
    QCOMPARE(got->received, 5);
    QCOMPARE(QDir(target()).entryList({QStringLiteral("*.dcm")}, QDir::Files).size(), 5);
}

/// What is listed and does not come is missing, whatever else came.
void DicomWebHabitsTest::listedSeriesThatIsNotThere()
{
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        const bool isLost = WebArchive::asksForObjects(line)
            && line.contains("/series/" + m_listed.seriesUid.toLatin1());
        return isLost ? WebReply{.status = 404, .contentType = "text/plain"}
                      : answer(line, {.body = "[]"});
    });
    const auto got = getStudy(server);
    VERIFY_ERROR(got, ErrorCode::TransferIncomplete);
    QCOMPARE(got.error().arguments.value(1), QStringLiteral("3"));
    QVERIFY(!QFileInfo::exists(target()));
}

void DicomWebHabitsTest::seriesWithoutObjects_data()
{
    QTest::addColumn<QByteArray>("counted");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("missing");
    QTest::newRow("counted as empty")
        << QByteArray(R"(,"00201209":{"vr":"IS","Value":[0]})") << 404 << QString();
    QTest::newRow("not counted, no such page") << QByteArray() << 404 << QStringLiteral("1");
    QTest::newRow("not counted, an empty answer") << QByteArray() << 204 << QStringLiteral("1");
    QTest::newRow("counted as more")
        << QByteArray(R"(,"00201209":{"vr":"IS","Value":[2]})") << 404 << QStringLiteral("2");
}

/// A series of which a server lists nothing, and gives nothing: it is none if it is counted so, and
/// else it is named; the other series are here in any case.
void DicomWebHabitsTest::seriesWithoutObjects()
{
    QFETCH(QByteArray, counted);
    QFETCH(int, status);
    QFETCH(QString, missing);
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        const bool isSecond = line.contains(m_unlisted.seriesUid.toLatin1());
        if (isSecond && WebArchive::asksForObjects(line))
            return WebReply{.status = status, .contentType = "text/plain"};
        WebReply reply = answer(line, {.body = "[]"});
        const QByteArray last = m_unlisted.seriesUid.toLatin1() + "\"]}";
        return WebReply{
            .contentType = reply.contentType, .body = reply.body.replace(last, last + counted)};
    });
    const auto got = getStudy(server);
    if (missing.isEmpty()) {
        VERIFY_DONE(got);
        QCOMPARE(got->received, 3);
        return;
    }
    VERIFY_ERROR(got, ErrorCode::TransferIncomplete);
    QCOMPARE(got.error().arguments.value(1).english().section(u' ', 0, 0), missing);
    QVERIFY2(ui::errorText(got.error()).contains(m_unlisted.seriesUid),
        qPrintable(ui::errorText(got.error())));
    // What came is kept, and nobody asks for it again.
    const auto again = getStudy(server);
    VERIFY_ERROR(again, ErrorCode::TransferIncomplete);
    const auto questions = server.questions();
    QCOMPARE(std::count_if(questions.begin(), questions.end(),
                 [&](const QByteArray& line) {
                     return WebArchive::asksForObjects(line)
                         && line.contains(m_listed.seriesUid.toLatin1());
                 }),
        1);
}

/// A login that ran out: servers lead to a page where people log in, which is there.
void DicomWebHabitsTest::storageIsLedToALogin()
{
    const test::WebServer server([](const QByteArray& line, const QByteArray&) {
        return line.startsWith("POST ") ? WebReply{.status = 302,
                   .contentType = "text/plain",
                   .moreHeaders = "Location: /dicom-web/login\r\n"}
                                        : WebReply{.contentType = "text/html", .body = "<html>"};
    });
    const auto sent = core::sendFiles(node(server), m_files, core::Progress());
    VERIFY_ERROR(sent, ErrorCode::NodeFailed);
    QVERIFY2(ui::errorText(sent.error()).contains(QLatin1String("HTTP 302")),
        qPrintable(ui::errorText(sent.error())));
    QCOMPARE(server.questions(), std::vector<QByteArray>{"POST /dicom-web/studies"});
}

void DicomWebHabitsTest::storageWithoutTheWord_data()
{
    QTest::addColumn<QByteArray>("type");
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<bool>("isStored");
    QTest::addColumn<int>("expected");
    const auto row = [](const char* name, const char* type, const char* body,
                         std::optional<ErrorCode> expected) {
        QTest::newRow(name) << QByteArray(type) << QByteArray(body) << !expected
                            << int(expected.value_or(ErrorCode::Internal));
    };
    const char* json = "application/dicom+json";
    row("nothing in JSON", json, "{}", ErrorCode::NodeFailed);
    row("an empty list of stored objects", json, R"({"00081199":{"vr":"SQ","Value":[]}})",
        ErrorCode::NodeFailed);
    row("no JSON", json, "stored", ErrorCode::NodeFailed);
    row("a page for people", "text/html; charset=utf-8", "<html>", ErrorCode::NodeNonsense);
    row("another object", json,
        R"({"00081199":{"vr":"SQ","Value":[{"00081155":{"vr":"UI","Value":["1.2.3"]}}]}})",
        ErrorCode::NodeFailed);
    row("words", "text/plain", "stored", ErrorCode::NodeNonsense);
    row("a page for people in XML", "application/xhtml+xml", "<html/>", ErrorCode::NodeNonsense);
    row("an object in a list", json, R"([{"00081199":{"vr":"SQ","Value":[{}]}}])", {});
    row("XML", "application/dicom+xml", "<NativeDicomModel/>", {});
    row("nothing at all", "application/dicom+json", "", {});
    row("nothing at all, as HTML", "text/html", "", {});
    row("nothing but a line end", "text/plain", "\r\n", {});
}

/// HTTP 200 alone does not mean that an object was stored.
void DicomWebHabitsTest::storageWithoutTheWord()
{
    QFETCH(QByteArray, type);
    QFETCH(QByteArray, body);
    QFETCH(bool, isStored);
    QFETCH(int, expected);
    const test::WebServer server([&](const QByteArray&, const QByteArray&) {
        return WebReply{.contentType = type, .body = body};
    });
    const auto sent = core::sendFiles(node(server), m_files, core::Progress());
    if (isStored) {
        VERIFY_DONE(sent);
        QCOMPARE(sent->sent, 3);
    } else {
        VERIFY_ERROR(sent, ErrorCode(expected));
        QCOMPARE(server.questions().size(), std::size_t(1));
    }
}

/// An answer that names what it stored names what was sent, whatever else is beside it.
void DicomWebHabitsTest::storageIsNamed()
{
    const test::WebServer server([&](const QByteArray&, const QByteArray& question) {
        QByteArray sent;
        for (auto object = m_first->objects().begin(); object != m_first->objects().end(); ++object)
            sent = question.contains(object.value()) ? object.key() : sent;
        return WebReply{.body = R"({"00081199":{"vr":"SQ","Value":[{"00081155":{"vr":"UI",)"
                                R"("Value":["1.2.3"]}},{"00081155":{"vr":"UI","Value":[")"
                + sent + R"("]}}]}})"};
    });
    const auto sent = core::sendFiles(node(server), m_files, core::Progress());
    VERIFY_DONE(sent);
    QCOMPARE(sent->sent, 3);
}

/// Servers of the field refuse questions for more than 200 results.
void DicomWebHabitsTest::pagesHaveALimit()
{
    const auto numberIn = [](const QByteArray& line, const char* name) {
        const QByteArray key = QByteArray(name) + '=';
        return line.mid(line.indexOf(key) + key.size()).split('&').front().toInt();
    };
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        const int limit = numberIn(line, "limit");
        const int offset = numberIn(line, "offset");
        if (limit > 200)
            return WebReply{.status = 400, .contentType = "text/plain", .body = "too many"};
        const QByteArray tag = line.contains("/instances?") ? "00080018" : "0020000D";
        QByteArrayList entries;
        for (int i = offset; i < std::min(offset + limit, 450); ++i) {
            entries.append("{\"" + tag + "\":{\"vr\":\"UI\",\"Value\":[\"1.2."
                + QByteArray::number(i) + "\"]}}");
        }
        return WebReply{.body = "[" + entries.join(',') + "]"};
    });
    const auto all = core::findStudies(node(server), {}, 1000, core::Progress());
    VERIFY_DONE(all);
    QCOMPARE(all->hits.size(), std::size_t(450));
    QVERIFY(!all->more);
    const auto some = core::findStudies(node(server), {}, 300, core::Progress());
    VERIFY_DONE(some);
    QCOMPARE(some->hits.size(), std::size_t(300));
    QVERIFY(some->more);
    QCOMPARE(some->hits.back().studyUid, QStringLiteral("1.2.299"));
    const auto exactly = core::findStudies(node(server), {}, 450, core::Progress());
    VERIFY_DONE(exactly);
    QCOMPARE(exactly->hits.size(), std::size_t(450));
    QVERIFY(!exactly->more);
    const auto instances = core::findInstances(
        node(server), QStringLiteral("1.2"), QStringLiteral("1.2.3"), core::Progress());
    VERIFY_DONE(instances);
    QCOMPARE(instances->size(), std::size_t(450));
    // A search that wants so many asks for the long page once.
    const auto questions = server.questions();
    const auto isLong = [](const QByteArray& line) { return line.contains("limit=1000&"); };
    QCOMPARE(std::count_if(questions.begin(), questions.end(), isLong), 2);
}

/// A server that knows no offset gives its first page again and again: all is on it, if it is long.
void DicomWebHabitsTest::pagesWithoutAnOffset()
{
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        const QByteArray limit = line.mid(line.indexOf("limit=") + 6).split('&').front();
        QByteArrayList entries;
        for (int i = 0; i < std::min(limit.toInt(), 450); ++i) {
            entries.append(
                R"({"00080018":{"vr":"UI","Value":["1.2.)" + QByteArray::number(i) + R"("]}})");
        }
        return WebReply{.body = "[" + entries.join(',') + "]"};
    });
    const auto instances = core::findInstances(
        node(server), QStringLiteral("1.2"), QStringLiteral("1.2.3"), core::Progress());
    VERIFY_DONE(instances);
    QCOMPARE(instances->size(), std::size_t(450));
}

void DicomWebHabitsTest::listsThatAreCut_data()
{
    QTest::addColumn<int>("counted");
    QTest::addColumn<QString>("missing");
    QTest::newRow("fewer are listed than there are") << 3 << QString();
    QTest::newRow("fewer come than are counted") << 5 << QStringLiteral("2 of 5");
}

/// Where a series has more objects than its list, it is fetched as a whole, and must be whole.
void DicomWebHabitsTest::listsThatAreCut()
{
    QFETCH(int, counted);
    QFETCH(QString, missing);
    const test::WebServer server([&](const QByteArray& line, const QByteArray&) {
        if (line.contains("/series?") && line.contains("offset=0")) {
            return WebReply{.body = R"([{"0020000E":{"vr":"UI","Value":[")"
                    + m_listed.seriesUid.toLatin1() + R"("]},"00201209":{"vr":"IS","Value":[)"
                    + QByteArray::number(counted) + "]}}]"};
        }
        if (line.contains("/instances?")) {
            return WebReply{.body = R"([{"00080018":{"vr":"UI","Value":[")"
                    + m_first->objects().firstKey() + R"("]}}])"};
        }
        return m_first->answer(line);
    });
    const auto got = getStudy(server);
    if (missing.isEmpty()) {
        VERIFY_DONE(got);
        QCOMPARE(got->received, 3);
        QCOMPARE(got->kept, 0);
        QCOMPARE(QDir(target()).entryList({QStringLiteral("*.dcm")}, QDir::Files).size(), 3);
        return;
    }
    VERIFY_ERROR(got, ErrorCode::TransferIncomplete);
    QCOMPARE(got.error().arguments.value(1).english(), missing);
    QVERIFY(!QFileInfo::exists(target()));
}

BURIN_TEST(DicomWebHabitsTest)

} // namespace dicomWebHabitsTest

#include "DicomWebHabitsTest.moc"
