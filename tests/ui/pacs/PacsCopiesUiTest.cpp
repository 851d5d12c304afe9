// SPDX-License-Identifier: Apache-2.0
#include "core/sources/PacsSource.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/servers/WebArchive.h"
#include "tests/support/servers/WebServer.h"
#include "ui/pacs/PacsBrowserDialog.h"
#include "ui/pacs/PacsCache.h"
#include "ui/settings/PacsSources.h"

#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QtTest>

#include <atomic>
#include <optional>

namespace pacsCopiesUiTest {

using test::WebArchive;
using test::WebReply;

namespace {

constexpr int patience = 60000; // ms; only a hang takes that long

} // namespace

/// What the PACS browser says of local copies, against a server whose counts the test chooses.
class PacsCopiesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void aCopyOfWhatHasGrown_data();
    void aCopyOfWhatHasGrown();

private:
    /// As a server answers that counts so many images in its study; −1: it does not say.
    [[nodiscard]] WebReply answer(const QByteArray& line, int counted) const;

    QTemporaryDir m_home;
    std::optional<WebArchive> m_archive;
};

void PacsCopiesUiTest::initTestCase()
{
    qputenv("XDG_CACHE_HOME", m_home.filePath(QStringLiteral("cache")).toUtf8());
    QCoreApplication::setOrganizationName(QStringLiteral("burin"));
    QCoreApplication::setApplicationName(QStringLiteral("burin"));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_home.path());
    test::SyntheticSeries series;
    series.size = {16, 16, 3};
    m_archive.emplace(test::writeSeries(series, m_home.filePath(QStringLiteral("sent"))));
}

void PacsCopiesUiTest::init()
{
    test::failOnUnexpectedMessages();
    ui::pacsCache().clear();
}

WebReply PacsCopiesUiTest::answer(const QByteArray& line, int counted) const
{
    WebReply reply = m_archive->answer(line);
    // Only studies are counted.
    if (counted >= 0 && line.startsWith("GET /dicom-web/studies?") && reply.body.endsWith("}]")) {
        reply.body.chop(2);
        reply.body += R"(,"00201208":{"vr":"IS","Value":[)" + QByteArray::number(counted) + "]}}]";
    }
    return reply;
}

void PacsCopiesUiTest::aCopyOfWhatHasGrown_data()
{
    QTest::addColumn<int>("counted");
    QTest::addColumn<QString>("sentence");
    QTest::addColumn<QString>("role");
    const QString here = QStringLiteral("✓ It is here already.");
    QTest::newRow("as many") << 3 << here << QStringLiteral("good");
    QTest::newRow("fewer") << 2 << here << QStringLiteral("good");
    QTest::newRow("unknown") << -1 << here << QStringLiteral("good");
    QTest::newRow("more")
        << 5
        << QStringLiteral("It is here already, with 3 of the 5 images that the source counts. To "
                          "fetch all of them, clear the local copies first, with the study closed.")
        << QStringLiteral("caution");
}

/// A copy stays as it is, whatever the source counts by now; what it counts is told.
void PacsCopiesUiTest::aCopyOfWhatHasGrown()
{
    QFETCH(int, counted);
    QFETCH(QString, sentence);
    QFETCH(QString, role);
    std::atomic<int> counts = 3;
    const test::WebServer server(
        [&](const QByteArray& line, const QByteArray&) { return answer(line, counts); });
    core::PacsSource source{.name = QStringLiteral("Cloud"), .node = {}, .movePort = {}};
    core::WebNode node;
    node.url = server.url();
    source.node = node;
    ui::setPacsSources({source});
    ui::PacsBrowserDialog dialog;
    dialog.show();
    auto& state = *dialog.findChild<QLabel*>(QStringLiteral("pacsState"));
    auto& hits = *dialog.findChild<QTreeWidget*>(QStringLiteral("pacsHits"));
    auto& download = *dialog.findChild<QPushButton*>(QStringLiteral("pacsDownload"));
    auto& search = *dialog.findChild<QPushButton*>(QStringLiteral("pacsSearch"));
    const auto searchAndChoose = [&] {
        QTRY_VERIFY(search.isEnabled());
        search.click();
        QTRY_COMPARE_WITH_TIMEOUT(state.text(), QStringLiteral("1 study"), patience);
        hits.setCurrentItem(hits.topLevelItem(0));
        QTRY_VERIFY(download.isEnabled());
    };
    searchAndChoose();
    if (QTest::currentTestFailed())
        return;
    download.click();
    QTRY_COMPARE_WITH_TIMEOUT(
        state.text(), QStringLiteral("✓ 3 images are here, each checked."), patience);
    counts = counted;
    searchAndChoose();
    if (QTest::currentTestFailed())
        return;
    QCOMPARE(hits.topLevelItem(0)->text(7), QStringLiteral("✓"));
    download.click();
    QTRY_COMPARE_WITH_TIMEOUT(state.text(), sentence, patience);
    QCOMPARE(state.property("role").toString(), role);
    QCOMPARE(hits.topLevelItem(0)->text(7), QStringLiteral("✓"));
    QVERIFY(dialog.findChild<QPushButton*>(QStringLiteral("pacsOpen"))->isEnabled());
}

BURIN_WINDOW_TEST(PacsCopiesUiTest)

} // namespace pacsCopiesUiTest

#include "PacsCopiesUiTest.moc"
