// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/CarvedExportDialog.h"

#include "core/nifti/NiftiWriter.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/dialogs/export/ExportDialog.h"
#include "ui/dialogs/export/Screenshot.h"
#include "ui/panels/lists/MeasurementsPanel.h"
#include "ui/panels/refine/RefinePanel.h"
#include "ui/report/AuditSaver.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

namespace carvedExportUiTest {

/// The dialog around core/export/CarvedVolume.h: what it offers, and what it says.
class CarvedExportUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void writesCoverageAndSaysWhyTheRestFails()
    {
        const QTemporaryDir folder;
        test::WindowFixture fixture(test::smallStudy());
        QVERIFY(fixture.workspace.session()->apply(test::drillAt(0)));
        QVERIFY(fixture.workspace.session()->settle());
        ui::CarvedExportDialog dialog(fixture.workspace);
        dialog.show();
        const auto child = [&dialog]<class T>(T*, const char* name) {
            return dialog.findChild<T*>(QLatin1String(name));
        };
        auto* series = child(static_cast<QRadioButton*>(nullptr), "carvedSeries");
        auto* nifti = child(static_cast<QRadioButton*>(nullptr), "carvedNifti");
        auto* coverage = child(static_cast<QRadioButton*>(nullptr), "carvedCoverage");
        auto* target = child(static_cast<QLineEdit*>(nullptr), "carvedTarget");
        auto* start = child(static_cast<QPushButton*>(nullptr), "carvedStart");
        auto* report = child(static_cast<QLabel*>(nullptr), "carvedReport");
        auto* state = child(static_cast<QLabel*>(nullptr), "carvedState");
        QVERIFY(!series->isEnabled()); // the study is no DICOM
        QVERIFY(nifti->isChecked());
        QVERIFY(target->text().endsWith(QStringLiteral("carved.nii.gz")));

        // The study lies nowhere, so its values cannot be had.
        target->setText(folder.filePath(QStringLiteral("a.nii.gz")));
        QTest::mouseClick(start, Qt::LeftButton);
        const auto ended = [&] {
            fixture.workspace.session()->poll();
            return !dialog.running();
        };
        QTRY_VERIFY(ended());
        QVERIFY(!state->text().isEmpty());
        QVERIFY(QDir(folder.path()).isEmpty());

        coverage->click();
        QVERIFY(target->text().endsWith(QStringLiteral("Sculpt 1 coverage.nii.gz")));
        const QSignalSpy exported(&dialog, &ui::CarvedExportDialog::exported);
        QTest::mouseClick(start, Qt::LeftButton);
        QTRY_VERIFY(ended());
        QCOMPARE(exported.size(), 1);
        QVERIFY(QFileInfo::exists(target->text()));
        QCOMPARE(QFileInfo(target->text()).path(), folder.path());
        QVERIFY(report->isVisible() && report->text().contains(QStringLiteral("Sculpt 1")));
        QVERIFY(report->text().contains(QStringLiteral("SHA-256")));
        // The dialog has grown: all of it is seen.
        QTRY_VERIFY(report->visibleRegion().boundingRect().height()
            >= report->heightForWidth(report->width()));
        const QString pictures = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!pictures.isEmpty())
            QVERIFY(
                dialog.grab().save(QDir(pictures).filePath(QStringLiteral("carved-export.png"))));
    }

    /// Not as the field shows it, rounded: a DICOM image may have no such value.
    void theLeastValueIsWrittenExactly()
    {
        const QTemporaryDir folder;
        const core::LoadedVolume whole = test::smallStudy();
        std::vector<float> values;
        for (const std::uint16_t code : whole.codes)
            values.push_back(float(whole.volume.encoding.value(code)) / 1000.0F - 0.00046F);
        const QString file = folder.filePath(QStringLiteral("study.nii"));
        QVERIFY(core::writeNifti(file,
            {.geometry = whole.volume.geometry,
                .voxels = std::span<const float>(values),
                .description = {}}));
        core::Result<core::LoadedVolume> loaded = core::loadVolume(file);
        QVERIFY(loaded);
        const auto least = float(loaded->volume.minimum);
        QVERIFY(std::abs(least + 1.00046F) < 1e-4F);
        test::WindowFixture fixture(*std::move(loaded));
        fixture.apply(test::carveAt(test::pointsInBrain(), 3.0));
        ui::CarvedExportDialog dialog(fixture.workspace);
        const QString target = folder.filePath(QStringLiteral("carved.nii"));
        dialog.findChild<QLineEdit*>(QStringLiteral("carvedTarget"))->setText(target);
        dialog.findChild<QPushButton*>(QStringLiteral("carvedStart"))->click();
        QTRY_VERIFY((fixture.session().poll(), !dialog.running()));
        const QByteArray bytes = test::bytesOf(target);
        const glm::dvec3 index = whole.volume.geometry.toIndex(test::pointsInBrain().front());
        constexpr std::size_t header = 352;
        const std::size_t at =
            header + sizeof(float) * test::smallIndexOf(glm::ivec3(glm::round(index)));
        QVERIFY(std::size_t(bytes.size()) >= at + sizeof(float));
        float filled = 0.0F;
        std::memcpy(&filled, bytes.constData() + at, sizeof filled);
        QVERIFY2(filled == least, qPrintable(QString::number(double(filled), 'g', 9)));
    }

    /// What is written of one point in time does not lie where that of another one would.
    void offersNameThePointInTime()
    {
        QSettings().remove(QStringLiteral("export/folder"));
        core::LoadedVolume study = test::smallStudy();
        study.volume.identity.modality = QStringLiteral("MR");
        core::SeriesAlternatives series;
        series.times = QStringList{QStringLiteral("0 ms"), QStringLiteral("40 ms")};
        series.time = 1;
        study.volume.alternatives = std::make_shared<const core::SeriesAlternatives>(series);
        test::WindowFixture fixture(std::move(study));
        const ui::CarvedExportDialog carved(fixture.workspace);
        const QString target = carved.findChild<QLineEdit*>(QStringLiteral("carvedTarget"))->text();
        QCOMPARE(QFileInfo(target).fileName(), QStringLiteral("MR point 2 - carved.nii.gz"));
        const ui::ExportDialog segments(fixture.workspace);
        const QString file = segments.findChild<QLineEdit*>(QStringLiteral("exportFile"))->text();
        QVERIFY2(
            QFileInfo(file).fileName().startsWith(QStringLiteral("MR point 2")), qPrintable(file));
    }

    /// A PNG that is called a JPEG would be taken for one.
    void aPictureIsWhatItsNameSays()
    {
        const QTemporaryDir folder;
        QImage white(8, 8, QImage::Format_RGB32);
        white.fill(Qt::white);
        for (const char* name : {"a.jpg", "a.JPEG", "a.tif"}) {
            const QString file = folder.filePath(QLatin1String(name));
            const auto saved = ui::savePicture(white, nullptr, file);
            QVERIFY(!saved);
            QCOMPARE(saved.error().code, core::ErrorCode::UnsupportedFormat);
            QVERIFY(!QFileInfo::exists(file));
        }
        for (const char* name : {"a.png", "a", "2026.11"})
            QVERIFY(ui::savePicture(white, nullptr, folder.filePath(QLatin1String(name))));
    }

    /// What other dialogs and panels write is offered as the export of segments is: beside the
    /// study, and named after it.
    void everyOfferIsNamedAfterTheStudy()
    {
        QSettings().remove(QStringLiteral("export/folder"));
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        const QTemporaryDir place;
        core::LoadedVolume study = test::smallStudy();
        study.volume.sourcePath = place.filePath(QStringLiteral("study"));
        study.volume.identity.patientName = QStringLiteral("DOE^JANE");
        study.volume.identity.modality = QStringLiteral("CT");
        study.volume.identity.studyDate = QStringLiteral("2026-11-20");
        study.volume.identity.seriesNumber = QStringLiteral("3");
        test::WindowFixture fixture(std::move(study));
        fixture.apply(test::drillAt(0));
        const QString beside = place.filePath(QStringLiteral("Burin exports"));
        const auto offer = [&beside](const char* of) {
            return QStringLiteral("%1/CT 2026-11-20 series 3 - %2").arg(beside, QLatin1String(of));
        };

        ui::CarvedExportDialog carved(fixture.workspace);
        auto* target = carved.findChild<QLineEdit*>(QStringLiteral("carvedTarget"));
        QCOMPARE(target->text(), offer("carved.nii.gz"));
        carved.findChild<QRadioButton*>(QStringLiteral("carvedCoverage"))->click();
        QCOMPARE(target->text(), offer("Sculpt 1 coverage.nii.gz"));
        QVERIFY(!QFileInfo::exists(beside)); // not before it is needed
        carved.findChild<QPushButton*>(QStringLiteral("carvedStart"))->click();
        QTRY_VERIFY((fixture.session().poll(), !carved.running()));
        QVERIFY(QFileInfo::exists(offer("Sculpt 1 coverage.nii.gz")));
        QVERIFY(QDir(beside).removeRecursively());

        QStringList offered;
        bool takes = false;
        const test::Dialogs dialogs([&](QWidget& dialog) {
            auto* choice = qobject_cast<QFileDialog*>(&dialog);
            if (!choice)
                return;
            offered += choice->selectedFiles().value(0);
            QDialog& asked = *choice;
            takes ? asked.accept() : asked.reject();
        });
        ui::MeasurementsPanel measurements(fixture.workspace);
        Q_EMIT measurements.findChild<QPushButton*>(QStringLiteral("saveMeasurements"))->clicked();
        ui::AuditSaver(fixture.workspace, &fixture.window).ask();
        ui::RefinePanel refine(fixture.workspace);
        Q_EMIT refine.findChild<QPushButton*>(QStringLiteral("saveSurface"))->clicked();
        QVERIFY(ui::askAndSavePicture(fixture.workspace, fixture.window).isEmpty());
        QCOMPARE(offered,
            (QStringList{offer("measurements.csv"), offer("audit.pdf"), offer("surface.stl"),
                offer("window.png")}));
        QVERIFY(!QFileInfo::exists(beside)); // nobody chose it
        takes = true;
        QVERIFY(!ui::askAndSavePicture(fixture.workspace, fixture.window).isEmpty());
        QVERIFY(QFileInfo::exists(offer("window.png")));
        QVERIFY(!QSettings().contains(QStringLiteral("export/folder")));
    }
};

BURIN_WINDOW_TEST(CarvedExportUiTest)

} // namespace carvedExportUiTest

#include "CarvedExportUiTest.moc"
