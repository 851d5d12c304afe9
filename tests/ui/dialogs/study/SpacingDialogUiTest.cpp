// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/ImageFiles.h"
#include "tests/support/series/VolumeFiles.h"
#include "ui/dialogs/export/Screenshot.h"
#include "ui/dialogs/study/SpacingDialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

namespace spacingDialogUiTest {

/// How large the voxels of pictures are is asked for on opening, and only there.
class SpacingDialogUiTest : public QObject, protected test::VolumeFiles {
    Q_OBJECT

    static QDoubleSpinBox& field(const QDialog& dialog, const char* name)
    {
        return *dialog.findChild<QDoubleSpinBox*>(QLatin1String(name));
    }
    static QPushButton& openButton(const QDialog& dialog)
    {
        return *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
    }
    static core::SeriesEntry entryOf(const glm::dvec3& said)
    {
        core::SeriesEntry entry;
        entry.key = QStringLiteral("slices");
        entry.geometry.size = {200, 100, 40};
        entry.saidSpacingMm = said;
        return entry;
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void opensWhenAllIsSaid()
    {
        ui::SpacingDialog dialog(entryOf({0.0, 0.0, 0.0}));
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QVERIFY(!openButton(dialog).isEnabled());
        field(dialog, "spacingColumns").setValue(0.5);
        field(dialog, "spacingRows").setValue(0.25);
        QVERIFY(!openButton(dialog).isEnabled());
        field(dialog, "spacingSlices").setValue(2.0);
        QVERIFY(openButton(dialog).isEnabled());
        QCOMPARE(dialog.repair(), QStringLiteral("spacing=0.5x0.25x2"));
        QCOMPARE(dialog.findChild<QLabel*>(QStringLiteral("spacingExtent"))->text(),
            QStringLiteral("The volume measures 100 × 25 × 80 mm."));
        field(dialog, "spacingRows").setValue(0.0);
        QVERIFY(!openButton(dialog).isEnabled());
    }

    void beginsWithWhatTheFilesSay()
    {
        ui::SpacingDialog dialog(entryOf({0.351562, 0.351562, 0.0}));
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            QVERIFY(dialog.grab().save(QDir(folder).filePath(QStringLiteral("spacing.png"))));
        QCOMPARE(field(dialog, "spacingColumns").value(), 0.351562);
        QCOMPARE(field(dialog, "spacingColumns").text(), QStringLiteral("0.351562 mm"));
        QVERIFY(!openButton(dialog).isEnabled());
        QVERIFY(dialog.focusWidget() == &field(dialog, "spacingSlices"));
        QTest::keyClicks(&field(dialog, "spacingSlices"), QStringLiteral("1.25"));
        QCOMPARE(dialog.repair(), QStringLiteral("spacing=0.351562x0.351562x1.25"));
        QTest::keyClick(&field(dialog, "spacingSlices"), Qt::Key_Return);
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
    }

    void aClickLetsTypeAnew()
    {
        ui::SpacingDialog dialog(entryOf({0.0, 0.0, 0.0}));
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        dialog.activateWindow();
        for (const char* name : {"spacingSlices", "spacingRows", "spacingColumns"}) {
            auto* line = field(dialog, name).findChild<QLineEdit*>();
            QTest::mouseClick(line, Qt::LeftButton, {}, QPoint(25, line->height() / 2));
            // As a window that is active has it, which needs a window manager.
            QFocusEvent focus(QEvent::FocusIn, Qt::MouseFocusReason);
            QCoreApplication::sendEvent(&field(dialog, name), &focus);
            QCoreApplication::processEvents();
            QTRY_VERIFY(!line->selectedText().isEmpty());
            QTest::keyClicks(line, QStringLiteral("2.5"));
        }
        QCOMPARE(dialog.repair(), QStringLiteral("spacing=2.5x2.5x2.5"));
    }

    void theWindowAsks_data()
    {
        QTest::addColumn<bool>("accepts");
        QTest::addRow("answered") << true;
        QTest::addRow("refused") << false;
    }

    void theWindowAsks()
    {
        QFETCH(bool, accepts);
        for (int k = 0; k < 3; ++k)
            put(QStringLiteral("%1.png").arg(k), test::png(test::picture<std::uint8_t>(k, 20, 10)));
        test::WindowFixture fixture(test::headFirstSupine());
        ui::StudyOpener& opener = fixture.window.opener();
        std::shared_ptr<core::LoadedVolume> opened;
        connect(&opener, &ui::StudyOpener::loaded, this,
            [&](const std::shared_ptr<core::LoadedVolume>& volume) { opened = volume; });
        const QSignalSpy failures(&opener, &ui::StudyOpener::failed);
        int asked = 0;
        QTimer answer;
        connect(&answer, &QTimer::timeout, this, [&] {
            auto* dialog = fixture.window.findChild<ui::SpacingDialog*>();
            if (dialog == nullptr || !dialog->isVisible())
                return;
            ++asked;
            for (const char* name : {"spacingColumns", "spacingRows", "spacingSlices"})
                field(*dialog, name).setValue(1.5);
            accepts ? dialog->accept() : dialog->reject();
        });
        answer.start(20);
        opener.open(m_folder->path());
        QTRY_COMPARE(asked, 1);
        QTRY_VERIFY(!opener.busy());
        QTRY_COMPARE(opened != nullptr, accepts);
        QCOMPARE(failures.size(), 0);
        if (accepts)
            QCOMPARE(opened->volume.repair, QStringLiteral("spacing=1.5x1.5x1.5"));
        // With its spacing nothing is asked.
        opened.reset();
        opener.open(m_folder->path(), QStringLiteral("+spacing=1x1x3"));
        QTRY_VERIFY(opened != nullptr);
        QCOMPARE(asked, 1);
        QCOMPARE(opened->volume.geometry.spacingMm(), glm::dvec3(1, 1, 3));
        // A picture of the window does not replace one of the study.
        QImage white(8, 8, QImage::Format_RGB32);
        white.fill(Qt::white);
        const QString slice = m_folder->filePath(QStringLiteral("0.png"));
        QVERIFY(!ui::savePicture(white, &opened->volume, slice));
        QVERIFY(QImage(slice).size() == QSize(20, 10));
        QVERIFY(ui::savePicture(white, nullptr, slice));
    }
};

BURIN_WINDOW_TEST(SpacingDialogUiTest)

} // namespace spacingDialogUiTest

#include "SpacingDialogUiTest.moc"
