// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SessionFiles.h"
#include "core/nifti/NiftiWriter.h"
#include "core/study/StudyLoader.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/ImageFiles.h"
#include "tests/support/series/SessionFiles.h"
#include "tests/support/series/SyntheticSeries.h"
#include "ui/dialogs/export/Screenshot.h"
#include "ui/frame/LoadingBar.h"
#include "ui/frame/StartPage.h"
#include "ui/settings/RecentStudies.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include <atomic>
#include <set>
#include <vector>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace openingUiTest {

/// A study that is loaded is put into the engine beside the GUI thread, which goes on meanwhile.
class OpeningUiTest : public QObject, test::WithApplication {
    Q_OBJECT

private:
    ui::StudyOpener& opener() const { return window().opener(); }
    /// Behind those who are told of it first.
    template <class Signal> void whenTold(Signal signal, std::function<void()> look)
    {
        connect(&opener(), signal, this, look);
    }

private Q_SLOTS:
    void initTestCase() { QApplication::setAttribute(Qt::AA_DontUseNativeDialogs); }
    void init() { makeApplication(); }
    void cleanup() { dropApplication(); }

    void nobodyWaitsForTheEngine_data()
    {
        QTest::addColumn<bool>("session");
        QTest::newRow("a study") << false;
        QTest::newRow("a session") << true;
    }

    void nobodyWaitsForTheEngine()
    {
        QFETCH(bool, session);
        const QString file = path("case/s.burin");
        if (session)
            test::writeSession(file, path("case/ct"));
        bool told = false;
        const auto look = [&] {
            told = true;
            // The engine makes its textures now: nothing is open yet, and who is told goes on.
            QVERIFY(!workspace().session());
            QVERIFY(opener().busy());
            QVERIFY(window().findChild<ui::LoadingBar*>()->isVisible());
        };
        whenTold(&ui::StudyOpener::loaded, look);
        whenTold(&ui::StudyOpener::sessionLoaded, look);
        QSignalSpy finished(&opener(), &ui::StudyOpener::finished);
        opener().open(session ? file : path("case/ct"));
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, patience);
        QVERIFY(told);
        QVERIFY(workspace().session());
        QVERIFY(!opener().busy());
        QVERIFY(!window().findChild<ui::LoadingBar*>()->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(window().views().refined(), patience);
    }

    /// In place of an open study its first slice shows until it is there.
    void anotherStudyTakesItsPlace()
    {
        m_fixture->open(path("case/ct"));
        test::SyntheticSeries series;
        series.studyUid = QStringLiteral("2.25.500");
        series.seriesUid = QStringLiteral("2.25.501");
        // Only what says how it is to be looked at shows early.
        series.adjust = [](DcmDataset& set, int) {
            set.putAndInsertString(DCM_WindowCenter, "40");
            set.putAndInsertString(DCM_WindowWidth, "400");
        };
        test::writeSeries(series, path("other"));
        bool early = false;
        whenTold(&ui::StudyOpener::loaded, [&] {
            early = window().views().earlySlice() != nullptr;
            QVERIFY(!workspace().session());
        });
        QSignalSpy finished(&opener(), &ui::StudyOpener::finished);
        opener().open(path("other"));
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, patience);
        QVERIFY(early);
        QVERIFY(!window().views().earlySlice());
        QCOMPARE(workspace().volume()->identity.studyUid, series.studyUid);
    }

    /// A dialog is about the study over which it was opened, however long it waits for an answer.
    void aDialogKeepsItsStudy()
    {
        m_fixture->open(path("case/ct"));
        test::SyntheticSeries series;
        series.studyUid = QStringLiteral("2.25.600");
        series.seriesUid = QStringLiteral("2.25.601");
        series.adjust = [](DcmDataset& set, int) { set.putAndInsertString(DCM_PatientID, "SYN2"); };
        test::writeSeries(series, path("other"));
        const QString file = path("window.dcm");
        QSignalSpy changed(&workspace(), &ui::Workspace::sessionChanged);
        QSignalSpy finished(&opener(), &ui::StudyOpener::finished);
        std::atomic<bool> isRead = false;
        opener().run(path("other"),
            [&isRead, place = path("other")](
                const core::Progress& progress, const core::EarlySliceListener&) {
                auto volume = core::loadVolume(place, QString(), progress);
                isRead = true;
                return volume;
            });
        int looks = 0;
        qsizetype changedMeanwhile = -1;
        const test::Dialogs dialogs([&](QWidget& dialog) {
            auto* choice = qobject_cast<QFileDialog*>(&dialog);
            // By then the study would have been opened.
            if (!choice || !isRead || ++looks < 20)
                return;
            changedMeanwhile = changed.size();
            choice->findChild<QLineEdit*>()->setText(file);
            QMetaObject::invokeMethod(choice, "accept", Qt::QueuedConnection);
        });
        const QString verdict = ui::askAndSavePicture(workspace(), window());
        QVERIFY2(verdict.contains(file), qPrintable(bar()));
        QCOMPARE(changedMeanwhile, qsizetype(0));
        QCOMPARE(changed.size(), qsizetype(0));
        QVERIFY(opener().busy());
        DcmFileFormat saved;
        QVERIFY(saved.loadFile(QFile::encodeName(file).constData()).good());
        OFString patient;
        QVERIFY(saved.getDataset()->findAndGetOFString(DCM_PatientID, patient).good());
        QCOMPARE(QByteArray(patient.c_str()), QByteArray("SYN1"));
        // What was held back comes once nobody is asked any more.
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, patience);
        QCOMPARE(workspace().volume()->identity.studyUid, series.studyUid);
        QVERIFY(!opener().busy());
    }

    /// An opening that is held back can still be called off.
    void whatIsHeldBackIsCalledOff()
    {
        ui::StudyOpener held;
        held.holdWhile([] { return true; });
        QSignalSpy failed(&held, &ui::StudyOpener::failed);
        QSignalSpy finished(&held, &ui::StudyOpener::finished);
        held.open(path("nowhere"));
        QTest::qWait(700);
        QVERIFY(held.busy());
        QCOMPARE(failed.size(), 0);
        QCOMPARE(finished.size(), 0);
        held.cancel();
        QVERIFY(!held.busy());
        QCOMPARE(finished.size(), 1);
        held.holdWhile({});
        held.open(path("nowhere"));
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, patience);
        QCOMPARE(finished.size(), 2);
    }

    /// Probabilities and the like are drawn in greys, and their window is as fine as they are.
    void fractionsHaveGreys()
    {
        core::VolumeGeometry geometry;
        geometry.size = {32, 32, 16};
        std::vector<float> values;
        for (std::size_t voxel = 0; voxel < geometry.voxelCount(); ++voxel)
            values.push_back(float(voxel % 32) / 31.0F);
        QVERIFY(core::writeNifti(path("map.nii"), {.geometry = geometry, .voxels = values}));
        m_fixture->open(path("map.nii"));
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
        ui::SliceView& axial = window().views().axial();
        const QImage picture = axial.grab().toImage();
        const QPoint middle = picture.rect().center();
        std::set<int> greys;
        for (int y = middle.y() - 60; y < middle.y() + 60; ++y) {
            for (int x = middle.x() - 60; x < middle.x() + 60; ++x) {
                const QRgb pixel = picture.pixel(x, y);
                if (qRed(pixel) == qGreen(pixel) && qGreen(pixel) == qBlue(pixel))
                    greys.insert(qGray(pixel));
            }
        }
        QVERIFY2(greys.size() > 30, qPrintable(QString::number(greys.size())));

        workspace().setWindowLevel({0.01, 0.02});
        const QPointF from(0.25 * axial.width(), 0.3 * axial.height());
        test::WindowFixture::mouse(axial, QEvent::MouseButtonPress, from);
        test::WindowFixture::mouse(axial, QEvent::MouseMove, from + QPointF(20.0, 0.0));
        test::WindowFixture::mouse(axial, QEvent::MouseMove, from + QPointF(40.0, 0.0));
        test::WindowFixture::mouse(axial, QEvent::MouseButtonRelease, from + QPointF(40.0, 0.0));
        const double width = workspace().windowLevel().width;
        QVERIFY2(width > 0.02 && width < 0.04, qPrintable(QString::number(width)));
    }

    void calledOffItLeavesNothing()
    {
        whenTold(&ui::StudyOpener::loaded, [this] { opener().cancel(); });
        QSignalSpy finished(&opener(), &ui::StudyOpener::finished);
        QSignalSpy changed(&workspace(), &ui::Workspace::sessionChanged);
        opener().open(path("case/ct"));
        QTRY_VERIFY_WITH_TIMEOUT(finished.size() >= 1, patience);
        disconnect(&opener(), &ui::StudyOpener::loaded, this, nullptr);
        QVERIFY(window().findChild<ui::StartPage*>()->isVisible());
        // What was made of it is gone before the next one is made.
        m_fixture->open(path("case/ct"));
        QCOMPARE(changed.size(), 1);
        QCOMPARE(m_fixture->session().history().rows().size(), std::size_t(0));
        window().closeStudy();
        QTRY_VERIFY_WITH_TIMEOUT(
            QDir(app::sessionFolder()).entryList(QDir::Files).isEmpty(), patience);
    }

    void theProgramEndsMeanwhile()
    {
        bool told = false;
        whenTold(&ui::StudyOpener::loaded, [&] { told = true; });
        opener().open(path("case/ct"));
        QTRY_VERIFY_WITH_TIMEOUT(told, patience);
        m_fixture->close();
        m_fixture->start();
        m_fixture->open(path("case/ct"));
        QCOMPARE(m_fixture->session().history().rows().size(), std::size_t(0));
    }

    /// How far apart the voxels of pictures are is asked once.
    void recentPicturesKnowTheirSpacing()
    {
        const QString folder = path("pictures");
        QVERIFY(QDir().mkpath(folder));
        for (int k = 0; k < 4; ++k) {
            QFile file(QStringLiteral("%1/%2.png").arg(folder).arg(k));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(test::png(test::picture<std::uint8_t>(k, 20, 16)));
        }
        QSignalSpy asked(&opener(), &ui::StudyOpener::spacingNeeded);
        QSignalSpy finished(&opener(), &ui::StudyOpener::finished);
        opener().open(folder, QStringLiteral("+spacing=0.5x0.25x2"));
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, patience);
        QCOMPARE(workspace().volume()->geometry.spacingMm(), glm::dvec3(0.5, 0.25, 2));
        window().closeStudy();
        QCOMPARE(ui::RecentStudies::paths().value(0), folder);
        Q_EMIT window().findChild<ui::StartPage*>()->recentRequested(folder);
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 2, patience);
        QCOMPARE(asked.size(), 0);
        QCOMPARE(workspace().volume()->geometry.spacingMm(), glm::dvec3(0.5, 0.25, 2));
        // Studies that say it themselves are not remembered by it.
        window().closeStudy();
        m_fixture->open(path("case/ct"));
        QCOMPARE(ui::RecentStudies::seriesOf(path("case/ct")), QString());
        QVERIFY(!ui::RecentStudies::seriesOf(folder).isEmpty());
    }
};

BURIN_WINDOW_TEST(OpeningUiTest)

} // namespace openingUiTest

#include "OpeningUiTest.moc"
