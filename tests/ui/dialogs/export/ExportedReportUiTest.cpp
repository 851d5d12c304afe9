// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/ExportDialog.h"

#include "core/dicom/deidentify/Deidentifier.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/series/SmallSeries.h"
#include "ui/base/Theme.h"
#include "ui/pacs/SendDialog.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>

#include <memory>

namespace exportedReportUiTest {

namespace {

QString text(const char* latin)
{
    return QLatin1String(latin);
}

/// A DICOM series on disk with a segment that has voxels and a code, and the dialog.
class ReportFixture {
public:
    ReportFixture()
        : workspace(frames)
    {
        test::SmallSeries series;
        series.placeEvenly({-4.0, -4.0, 10.0}, {0.0, 0.0, 2.0});
        core::LoadedVolume loaded;
        loaded.volume = series.write(folder.filePath(text("series")));
        loaded.codes.resize(loaded.volume.geometry.voxelCount());
        auto made = core::EditSession::create(engine, std::move(loaded), {});
        if (!made)
            qFatal("no session");
        workspace.setSession(std::move(*made));
        const core::Volume& volume = *workspace.volume();
        apply(core::AddSegment{
            text("Skull"), 0x4a9bff, {text("SCT"), text("89546000"), text("Skull")}});
        apply(test::seedAt(1, {volume.geometry.toWorld({2, 2, 2})}));
        apply(test::growBetween(volume.encoding.value(0) - 1.0, volume.encoding.value(0) + 1.0, 2));
        QObject::connect(&wakeUp, &QTimer::timeout, [this] { workspace.session()->poll(); });
        wakeUp.start(1);
        dialog = std::make_unique<ui::ExportDialog>(workspace);
        dialog->show();
        dialog->choose(core::ExportFormat::Sr);
        dialog->findChild<QLineEdit*>(text("exportFile"))->setText(path("report.dcm"));
    }
    void apply(const core::Edit& edit)
    {
        if (!workspace.session()->apply(edit) || !workspace.session()->settle())
            qFatal("an edit of the fixture failed");
    }
    [[nodiscard]] QString path(const char* name) const { return folder.filePath(text(name)); }
    [[nodiscard]] QAbstractButton& button(const char* name) const
    {
        return *dialog->findChild<QAbstractButton*>(text(name));
    }
    /// Clicks on Export, and answers the question that comes up.
    /// @return the question; empty: there was none
    QString exportAnswering(QMessageBox::StandardButton with)
    {
        QString asked;
        QTimer answer;
        answer.setSingleShot(true);
        QObject::connect(&answer, &QTimer::timeout, [&asked, with] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box)
                return;
            asked = box->text();
            box->button(with)->click();
        });
        answer.start(0);
        button("exportStart").click();
        return asked;
    }

    QTemporaryDir folder;
    reference::ReferenceEngine engine;
    test::NoFrames frames;
    ui::Workspace workspace;
    QTimer wakeUp;
    std::unique_ptr<ui::ExportDialog> dialog;
};

} // namespace

/// A DICOM SR is exported with the SEG that it refers to: both are the export.
class ExportedReportUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_settings.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        ui::theme::apply(*qApp);
    }

    void asksBeforeItReplacesTheSeg()
    {
        ReportFixture fixture;
        const QString seg = fixture.path("report-seg.dcm");
        QFile there(seg);
        QVERIFY(there.open(QIODevice::WriteOnly) && there.write("mine") == 4);
        there.close();
        QVERIFY(fixture.exportAnswering(QMessageBox::No).contains(text("report-seg.dcm")));
        QVERIFY(!fixture.dialog->running());
        QCOMPARE(test::bytesOf(seg), QByteArray("mine"));
        const QSignalSpy exported(fixture.dialog.get(), &ui::ExportDialog::exported);
        QVERIFY(fixture.exportAnswering(QMessageBox::Yes).contains(text("report-seg.dcm")));
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, 60000);
        QVERIFY(test::bytesOf(seg) != QByteArray("mine"));
        QVERIFY(QFile::exists(fixture.path("report.dcm")));
    }

    /// At a PACS a report without it would be of something that is not there.
    void sendsBoth()
    {
        ReportFixture fixture;
        const QSignalSpy exported(fixture.dialog.get(), &ui::ExportDialog::exported);
        fixture.button("exportStart").click();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, 60000);
        QString offered;
        QTimer look;
        look.setSingleShot(true);
        connect(&look, &QTimer::timeout, this, [&offered] {
            auto* send = qobject_cast<ui::SendDialog*>(QApplication::activeModalWidget());
            if (!send)
                return;
            for (const QLabel* label : send->findChildren<QLabel*>()) {
                if (label->property("role").toString() == text("heading"))
                    offered = label->text();
            }
            QDialog& asked = *send;
            asked.reject();
        });
        look.start(0);
        fixture.button("exportSend").click();
        QCOMPARE(offered, text("2 files"));
    }

    /// In the file segments are named by their codes then, and so is the file.
    void theNameOfADeidentifiedFileIsNobodys()
    {
        ReportFixture fixture;
        fixture.apply(test::renameSegment(1, text("Mrs Doe")));
        ui::ExportDialog dialog(fixture.workspace);
        const auto* file = dialog.findChild<QLineEdit*>(text("exportFile"));
        QVERIFY2(file->text().endsWith(text("Mrs Doe.dcm")), qPrintable(file->text()));
        auto* deidentify = dialog.findChild<QAbstractButton*>(text("deidentify"));
        deidentify->click();
        QVERIFY2(file->text().endsWith(text("Skull.dcm")), qPrintable(file->text()));
        QVERIFY2(!file->text().contains(text("Doe")), qPrintable(file->text()));
        deidentify->click();
        QVERIFY2(file->text().endsWith(text("Mrs Doe.dcm")), qPrintable(file->text()));
    }

    /// The file would say that its dates were changed, and have the true ones.
    void datesAreNotShiftedByNone()
    {
        const ReportFixture fixture;
        fixture.button("deidentify").click();
        auto* dates = fixture.dialog->findChild<QComboBox*>(text("deidentifyDates"));
        auto* days = fixture.dialog->findChild<QSpinBox*>(text("deidentifyDays"));
        QVERIFY(fixture.button("exportStart").isEnabled());
        days->setValue(0);
        QVERIFY(fixture.button("exportStart").isEnabled()); // they are removed
        dates->setCurrentIndex(dates->findData(int(core::DeidentifyOptions::Dates::Shift)));
        QVERIFY(!fixture.button("exportStart").isEnabled());
        const auto* state = fixture.dialog->findChild<QLabel*>(text("exportState"));
        QVERIFY2(state->text().contains(text("whole days")), qPrintable(state->text()));
        days->setValue(-3);
        QVERIFY(fixture.button("exportStart").isEnabled());
        fixture.button("deidentify").click();
        days->setValue(0);
        QVERIFY(fixture.button("exportStart").isEnabled());
    }

private:
    QTemporaryDir m_settings;
};

BURIN_WINDOW_TEST(ExportedReportUiTest)

} // namespace exportedReportUiTest

#include "ExportedReportUiTest.moc"
