// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionSalvage.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/MarkedSeries.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/export/DeidentifySessionDialog.h"
#include "ui/workspace/Workspace.h"

#include <QApplication>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

namespace deidentifySessionUiTest {

/// "Save de-identified session as …" in the window as `burin open` makes it.
class DeidentifySessionUiTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<test::ApplicationFixture> m_fixture;

    /// What the menu opens.
    [[nodiscard]] ui::DeidentifySessionDialog& dialog() const
    {
        m_fixture->window().actionTable()[QStringLiteral("file.deidentify")].trigger();
        auto* made = m_fixture->window().findChild<ui::DeidentifySessionDialog*>();
        if (!made)
            qFatal("no dialog");
        return *made;
    }
    static void choose(const ui::DeidentifySessionDialog& dialog, const QString& file)
    {
        dialog.findChild<QLineEdit*>(QStringLiteral("deidentifiedFile"))->setText(file);
    }
    static void save(const ui::DeidentifySessionDialog& dialog)
    {
        dialog.findChild<QPushButton*>(QStringLiteral("deidentifiedSave"))->click();
    }
    static QLabel& label(const ui::DeidentifySessionDialog& dialog, const char* name)
    {
        return *dialog.findChild<QLabel*>(QLatin1String(name));
    }

private Q_SLOTS:
    void init()
    {
        m_fixture = std::make_unique<test::ApplicationFixture>();
        test::writeSeries(test::markedSeries(), m_fixture->path("marked"));
    }

    void onlyWithASession()
    {
        QAction& action = m_fixture->window().actionTable()[QStringLiteral("file.deidentify")];
        QVERIFY(!action.isEnabled());
        m_fixture->open(m_fixture->path("marked"));
        QTRY_VERIFY(action.isEnabled());
    }

    void theCopyNamesNobodyAndTheSessionGoesOn()
    {
        m_fixture->open(m_fixture->path("marked"));
        m_fixture->edit(test::addSegment("Leber"));
        const QString open = m_fixture->session().file();
        ui::DeidentifySessionDialog& asked = dialog();
        const QString target = m_fixture->path("for others.burin");
        choose(asked, target);
        QSignalSpy saved(&asked, &ui::DeidentifySessionDialog::saved);
        save(asked);
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::ApplicationFixture::patience);
        QVERIFY2(test::markersIn(target).isEmpty(), test::markersIn(target).join(' ').constData());
        const auto contents = core::checkSession(target);
        QVERIFY(contents && contents->isWhole());
        QCOMPARE(contents->rows.size(), std::size_t(1));
        QCOMPARE(contents->rows.back().stateHash, m_fixture->session().stateHash());
        const QString report = label(asked, "deidentifiedReport").text();
        QVERIFY2(report.contains(QLatin1String("SHA-256")), qPrintable(report));
        test::look(asked.grab(), "deidentify-session.png");
        QCOMPARE(m_fixture->session().file(), open);
        m_fixture->edit(test::addSegment("Niere"));
        QCOMPARE(m_fixture->session().history().rows().size(), std::size_t(2));
        // The marks would have been found: they are in the session itself.
        m_fixture->close();
        QVERIFY(!test::markersIn(open).isEmpty());
        QCOMPARE(core::checkSession(target)->rows.size(), std::size_t(1));
    }

    void aSegmentNamedAfterThePatientIsSaid()
    {
        m_fixture->open(m_fixture->path("marked"));
        m_fixture->edit(test::addSegment(
            qPrintable(m_fixture->workspace().volume()->identity.patientName.section(u'^', 0, 0))));
        ui::DeidentifySessionDialog& asked = dialog();
        const QString target = m_fixture->path("no.burin");
        choose(asked, target);
        save(asked);
        QTRY_VERIFY_WITH_TIMEOUT(!asked.running(), test::ApplicationFixture::patience);
        const QLabel& state = label(asked, "deidentifiedState");
        QTRY_COMPARE(state.property("role").toString(), QStringLiteral("bad"));
        QVERIFY2(state.text().contains(QLatin1String("step 1")), qPrintable(state.text()));
        QVERIFY(!QFileInfo::exists(target));
    }

    void theOpenSessionIsNotReplaced()
    {
        m_fixture->open(m_fixture->path("marked"));
        ui::DeidentifySessionDialog& asked = dialog();
        choose(asked, m_fixture->session().file());
        save(asked);
        QVERIFY(!asked.running());
        QCOMPARE(
            label(asked, "deidentifiedState").property("role").toString(), QStringLiteral("bad"));
    }
};

BURIN_WINDOW_TEST(DeidentifySessionUiTest)

} // namespace deidentifySessionUiTest

#include "DeidentifySessionUiTest.moc"
