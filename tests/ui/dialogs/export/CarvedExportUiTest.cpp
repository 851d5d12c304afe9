// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/CarvedExportDialog.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QTemporaryDir>
#include <QtTest>

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
        QVERIFY(target->text().endsWith(QStringLiteral("coverage.nii.gz")));
        const QSignalSpy exported(&dialog, &ui::CarvedExportDialog::exported);
        QTest::mouseClick(start, Qt::LeftButton);
        QTRY_VERIFY(ended());
        QCOMPARE(exported.size(), 1);
        QVERIFY(QFileInfo::exists(folder.filePath(QStringLiteral("coverage.nii.gz"))));
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
};

BURIN_WINDOW_TEST(CarvedExportUiTest)

} // namespace carvedExportUiTest

#include "CarvedExportUiTest.moc"
