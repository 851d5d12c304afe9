// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/defective/DefectiveSeries.h"
#include "ui/frame/PanelSection.h"
#include "ui/panels/SeriesDoctorPanel.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Workspace.h"

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace seriesDoctorUiTest {

/// The series doctor in the window: found, chosen, applied, taken back.
class SeriesDoctorUiTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<test::ApplicationFixture> m_fixture;

    [[nodiscard]] ui::MainWindow& window() const { return m_fixture->window(); }
    template <class T> [[nodiscard]] T* find(const char* name) const
    {
        return doctor()->findChild<T*>(QLatin1String(name));
    }
    [[nodiscard]] ui::SeriesDoctorPanel* doctor() const
    {
        return window().findChild<ui::SeriesDoctorPanel*>();
    }
    [[nodiscard]] const core::Volume& volume() const { return *m_fixture->workspace().volume(); }
    /// Presses a button that opens the study anew, and waits for it.
    void pressAndWait(const char* button) const
    {
        QSignalSpy opened(&m_fixture->workspace(), &ui::Workspace::sessionChanged);
        find<QPushButton>(button)->click();
        QTRY_VERIFY_WITH_TIMEOUT(m_fixture->workspace().volume() != nullptr && opened.count() > 1,
            test::ApplicationFixture::patience);
    }

private Q_SLOTS:
    void init()
    {
        m_fixture = std::make_unique<test::ApplicationFixture>();
        test::writeSeries(test::tiltedSeries(0.5), m_fixture->path("tilted"));
    }

    void showsWhatWasFound()
    {
        m_fixture->open(m_fixture->path("case/ct"));
        QVERIFY(!doctor()->isVisible());
        QVERIFY(!window().actionTable()[QStringLiteral("file.seriesDoctor")].isEnabled());
        m_fixture->open(m_fixture->path("tilted"));
        QTRY_VERIFY_WITH_TIMEOUT(doctor()->isVisible(), test::ApplicationFixture::patience);
        QVERIFY(window().actionTable()[QStringLiteral("file.seriesDoctor")].isEnabled());
        QVERIFY(find<QLabel>("finding")->text().contains(QLatin1String("tilted by")));
        QVERIFY(find<QRadioButton>("repairChoice0")->isChecked());
        auto* keep = find<QPushButton>("applyRepair");
        QCOMPARE(keep->text(), QStringLiteral("Keep as it is"));
        QVERIFY(keep->toolTip().contains(QStringLiteral("nothing of the series changes")));
        find<QRadioButton>("repairChoice1")->click();
        QCOMPARE(keep->text(), QStringLiteral("Apply"));
        QVERIFY(keep->toolTip().contains(QStringLiteral("with the repairs")));
        find<QRadioButton>("repairChoice0")->click();
        QCOMPARE(keep->text(), QStringLiteral("Keep as it is"));
    }

    void keepingItAcceptsTheCaution()
    {
        m_fixture->open(m_fixture->path("tilted"));
        QVERIFY(!m_fixture->workspace().cautionAccepted());
        find<QPushButton>("applyRepair")->click();
        QVERIFY(m_fixture->workspace().cautionAccepted());
        QVERIFY(!find<QPushButton>("applyRepair")->isEnabled());
    }

    void repairsAndTakesItBack()
    {
        m_fixture->open(m_fixture->path("tilted"));
        m_fixture->edit(test::addSegment("On the series as it is"));
        find<QRadioButton>("repairChoice1")->click();
        QVERIFY(find<QLabel>("repairEffect")->isVisible());
        QVERIFY(find<QLabel>("gridAfter")->text().startsWith(QStringLiteral("24 × 22 × 10")));
        // Both grids stand side by side in whole, once the panel has its place.
        QTRY_VERIFY(doctor()->mapTo(&window(), QPoint()).x() > window().width() / 2);
        for (const char* grid : {"gridNow", "gridAfter"})
            QTRY_VERIFY(find<QLabel>(grid)->width() >= find<QLabel>(grid)->sizeHint().width());
        QVERIFY2(!find<QLabel>("repairEffect")->text().contains(QLatin1String("by 0 ")),
            qPrintable(find<QLabel>("repairEffect")->text()));
        QTRY_VERIFY_WITH_TIMEOUT(window().views().refined(), test::ApplicationFixture::patience);
        test::look(window().grab(), "doctor-chosen.png");
        pressAndWait("applyRepair");
        QCOMPARE(volume().repair, QStringLiteral("tilt"));
        QVERIFY(!volume().needsCaution());
        QVERIFY(m_fixture->session().document().segments.empty());
        QVERIFY(find<QRadioButton>("repairChoice1")->isChecked());
        QVERIFY(!find<QPushButton>("applyRepair")->isEnabled());

        m_fixture->edit(test::addSegment("On the repaired one"));
        m_fixture->edit(test::addSegment("Another"));
        find<QRadioButton>("repairChoice0")->click();
        QCOMPARE(find<QPushButton>("applyRepair")->text(), QStringLiteral("Open as it is"));
        pressAndWait("applyRepair");
        QVERIFY(volume().repair.isEmpty());
        // What was drawn is where it was drawn.
        QCOMPARE(m_fixture->session().document().segments.size(), std::size_t(1));
        find<QRadioButton>("repairChoice1")->click();
        pressAndWait("applyRepair");
        QCOMPARE(m_fixture->session().document().segments.size(), std::size_t(2));
    }

    void opensAnotherPointInTime()
    {
        test::SyntheticSeries first;
        first.adjust = [](DcmDataset& set, int) { set.putAndInsertString(DCM_TriggerTime, "80"); };
        test::SyntheticSeries second = first;
        second.fileName = [](int k) { return QStringLiteral("b%1").arg(k); };
        second.adjust = [](DcmDataset& set, int k) {
            set.putAndInsertString(DCM_TriggerTime, "160");
            set.putAndInsertString(DCM_SOPInstanceUID, QByteArray::number(900 + k).constData());
        };
        second.stored = [](const glm::ivec3& index) { return index.z + 1; };
        test::writeSeries(first, m_fixture->path("times"));
        test::writeSeries(second, m_fixture->path("times"));
        window().opener().open(m_fixture->path("times"), first.seriesUid + QStringLiteral("@2"));
        QTRY_VERIFY_WITH_TIMEOUT(
            m_fixture->workspace().volume(), test::ApplicationFixture::patience);
        window().bringUp(*doctor());
        QVERIFY(find<QSlider>("timeSlider")->isVisible());
        QCOMPARE(find<QSlider>("timeSlider")->value(), 1);
        QVERIFY2(window().windowTitle().contains(QLatin1String("point 2 of 2")),
            qPrintable(window().windowTitle()));
        QTRY_VERIFY_WITH_TIMEOUT(window().views().refined(), test::ApplicationFixture::patience);
        test::look(window().grab(), "doctor-time.png");
        QVERIFY(!find<QPushButton>("openTime")->isEnabled());
        find<QSlider>("timeSlider")->setValue(0);
        QVERIFY(find<QLabel>("timeText")->text().contains(QLatin1String("80 ms")));
        QVERIFY(find<QLabel>("timeText")->text().contains(QLatin1String("Masks stay")));
        pressAndWait("openTime");
        QCOMPARE(volume().alternatives->time, 0);
    }
};

BURIN_WINDOW_TEST(SeriesDoctorUiTest)

} // namespace seriesDoctorUiTest

#include "SeriesDoctorUiTest.moc"
