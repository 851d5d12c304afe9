// SPDX-License-Identifier: Apache-2.0
#include "core/sources/PacsSource.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/servers/PacsServers.h"
#include "ui/pacs/HitsTree.h"
#include "ui/pacs/PacsBrowserDialog.h"
#include "ui/settings/PacsSources.h"

#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

namespace pacsSeriesUiTest {

namespace {

constexpr int patience = 60000; // ms; only a hang takes that long

} // namespace

/// What the PACS browser asks for when studies are expanded.
class PacsSeriesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        qputenv("XDG_CACHE_HOME", m_home.filePath(QStringLiteral("cache")).toUtf8());
        QCoreApplication::setOrganizationName(QStringLiteral("burin"));
        QCoreApplication::setApplicationName(QStringLiteral("burin"));
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_home.path());
    }
    void init() { test::failOnUnexpectedMessages(); }

    /// The next one is expanded before the source has said anything of the one before.
    void everyStudyThatIsExpandedIsAskedFor()
    {
        core::PacsSource gone{.name = QStringLiteral("Gone"), .node = {}, .movePort = {}};
        core::WebNode node;
        node.url = QUrl(QStringLiteral("http://127.0.0.1:%1/dicom-web").arg(test::freePort()));
        gone.node = node;
        ui::setPacsSources({gone});
        ui::PacsBrowserDialog dialog;
        dialog.show();
        dialog.findChild<QPushButton*>(QStringLiteral("pacsSearch"))->click();
        const auto* state = dialog.findChild<QLabel*>(QStringLiteral("pacsState"));
        const QString refused =
            node.name() + QStringLiteral(" cannot be reached: Connection refused");
        QTRY_COMPARE_WITH_TIMEOUT(state->text(), refused, patience);

        auto* hits = dialog.findChild<ui::HitsTree*>();
        QVERIFY(hits);
        std::vector<core::StudyHit> studies(3);
        for (std::size_t i = 0; i < studies.size(); ++i)
            studies[i].studyUid = QStringLiteral("2.25.%1").arg(i + 1);
        hits->showStudies(studies);
        for (int row = 0; row < hits->topLevelItemCount(); ++row)
            hits->topLevelItem(row)->setExpanded(true);
        for (int row = 0; row < hits->topLevelItemCount(); ++row)
            QTRY_COMPARE_WITH_TIMEOUT(
                hits->topLevelItem(row)->child(0)->text(0), refused, patience);
    }

private:
    QTemporaryDir m_home;
};

BURIN_WINDOW_TEST(PacsSeriesUiTest)

} // namespace pacsSeriesUiTest

#include "PacsSeriesUiTest.moc"
