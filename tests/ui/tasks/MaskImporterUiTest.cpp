// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/MaskImporter.h"

#include "core/nifti/NiftiWriter.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/series/SyntheticSeries.h"
#include "ui/dialogs/MaskOrderDialog.h"
#include "ui/frame/MessageBar.h"

#include <QApplication>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace maskImporterUiTest {

namespace {

class ImportFixture : public test::WindowFixture {
public:
    ImportFixture()
        : test::WindowFixture(test::headFirstSupine())
    {
    }
    [[nodiscard]] QString path(const char* name) const
    {
        return folder.filePath(QLatin1String(name));
    }
    /// Label 1 in two slices, 2 in one voxel, on the study's grid or beside it.
    [[nodiscard]] QString mask(const char* name, const glm::dvec3& movedMm = glm::dvec3(0.0)) const
    {
        core::VolumeGeometry geometry = workspace.volume()->geometry;
        geometry.indexToWorld[3] += glm::dvec4(movedMm, 0.0);
        std::vector<std::uint8_t> labels(geometry.voxelCount(), 0);
        const std::size_t slice = std::size_t(geometry.size.x) * std::size_t(geometry.size.y);
        std::fill_n(labels.begin(), 2 * slice, std::uint8_t(1));
        labels[5 * slice] = 2;
        const auto written =
            core::writeNifti(path(name), {.geometry = geometry, .voxels = labels}, false);
        return written ? path(name) : QString();
    }
    /// Until the file that is being read has become a step, or has not.
    void finish()
    {
        QTRY_VERIFY(!window.importer().busy());
        QVERIFY(session().settle());
    }
    void drop(const QStringList& files)
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files)
            urls += QUrl::fromLocalFile(file);
        data.setUrls(urls);
        QDragEnterEvent enter(
            QPoint(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &event);
    }
    void drop(const QString& file) { drop(QStringList{file}); }
    QTemporaryDir folder;
};

} // namespace

class MaskImporterUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void segmentsComeInAsOneStep()
    {
        ImportFixture fixture;
        const QByteArray before = fixture.session().stateHash();
        QSignalSpy imported(&fixture.window.importer(), &ui::MaskImporter::imported);
        fixture.window.importer().import(fixture.mask("some.nii"));
        QVERIFY(fixture.window.importer().busy());
        fixture.finish();
        QCOMPARE(imported.count(), 1);
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(1));
        const auto& segments = fixture.session().document().segments;
        QCOMPARE(segments.size(), std::size_t(2));
        QVERIFY(imported[0][1].toStringList().isEmpty());
        QCOMPARE(fixture.workspace.activeSegment(), int(segments[0].label)); // none was before
        const QString sentence = fixture.window.messages().sentence();
        QVERIFY2(sentence.contains(QStringLiteral("2 segments")), qPrintable(sentence));
        reference::DenseFields fields = fixture.engine.fields();
        const auto& labels = fields.labels(0);
        QCOMPARE(int(labels.at({3, 4, 0})), int(segments[0].label));
        QCOMPARE(int(labels.at({3, 4, 1})), int(segments[0].label));
        QCOMPARE(int(labels.at({0, 0, 5})), int(segments[1].label));
        QCOMPARE(int(labels.at({3, 4, 5})), 0);
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), before);
    }

    /// Nobody who brings a mask along wants to see the skin alone.
    void whatCameInIsSeenInTheVolume()
    {
        ImportFixture fixture;
        const auto context = [&] { return fixture.workspace.volumeDisplay().context; };
        fixture.window.importer().import(fixture.path("missing.nii"));
        QTRY_VERIFY(!fixture.window.importer().busy());
        QCOMPARE(context(), gpu::Context::Opaque);
        const QString mask = fixture.mask("some.nii");
        fixture.window.importer().import(mask);
        fixture.finish();
        QCOMPARE(context(), gpu::Context::Translucent);
        // Whatever else shows segments is left as it was chosen.
        for (const gpu::Context chosen : {gpu::Context::CutAway, gpu::Context::Hidden}) {
            QVERIFY(fixture.session().undo());
            QVERIFY(fixture.session().settle());
            ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
            display.context = chosen;
            fixture.workspace.setVolumeDisplay(display);
            fixture.window.importer().import(mask);
            fixture.finish();
            QCOMPARE(context(), chosen);
        }
    }

    /// The button of the message is about the import, whatever was done since.
    void theMessageUndoesTheImportAlone()
    {
        ImportFixture fixture;
        const QString mask = fixture.mask("some.nii");
        const auto press = [&fixture] {
            for (auto* button : fixture.window.messages().findChildren<QPushButton*>()) {
                if (button->text() == QLatin1String("Undo"))
                    button->click();
            }
        };
        fixture.window.importer().import(mask);
        fixture.finish();
        press();
        QVERIFY(fixture.session().settle());
        QCOMPARE(int(fixture.session().history().position()), 0);
        fixture.window.importer().import(mask);
        fixture.finish();
        fixture.apply(test::newSegment(QStringLiteral("Later")));
        const core::RowId position = fixture.session().history().position();
        QVERIFY(!fixture.window.messages().isVisible()); // it offers the last step alone
        press();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().position(), position);
    }

    void aMaskThatIsDroppedIsTakenIn()
    {
        ImportFixture fixture;
        fixture.drop(fixture.mask("some-seg.nii"));
        fixture.finish();
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(1));
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(2));
    }

    void severalMasksAreNotTakenForOne()
    {
        ImportFixture fixture;
        fixture.drop({fixture.mask("one-seg.nii"), fixture.mask("two-seg.nii")});
        QVERIFY(!fixture.window.importer().busy());
        const QString sentence = fixture.window.messages().sentence();
        QVERIFY2(sentence.contains(QStringLiteral("None of the 2 masks")), qPrintable(sentence));
        QVERIFY(fixture.session().history().rows().empty());
    }

    /// Slices are those of their folder; of whole studies one is opened, which is told.
    void severalFilesAreOpenedAsTheyBelong()
    {
        ImportFixture fixture;
        const QString slices = fixture.path("ct");
        const QStringList files = test::writeSeries({}, slices);
        QSignalSpy loaded(&fixture.window.opener(), &ui::StudyOpener::loaded);
        QSignalSpy finished(&fixture.window.opener(), &ui::StudyOpener::finished);
        fixture.drop(files);
        QTRY_COMPARE(finished.size(), 1);
        QCOMPARE(loaded.size(), 1);
        QCOMPARE(loaded[0][1].toString(), slices);
        QVERIFY2(fixture.window.messages().sentence().isEmpty(),
            qPrintable(fixture.window.messages().sentence()));

        const QString volume = fixture.mask("one.nii");
        fixture.drop({fixture.path("a.raw"), volume, fixture.mask("two.nii")});
        QTRY_COMPARE(finished.size(), 2);
        QCOMPARE(loaded.size(), 2);
        QCOMPARE(loaded[1][1].toString(), volume);
        const QString sentence = fixture.window.messages().sentence();
        QVERIFY2(
            sentence.contains(QStringLiteral("Only one.nii was opened")), qPrintable(sentence));
    }

    /// Names of studies may sound like masks.
    void whatHoldsAnImageIsOpened()
    {
        ImportFixture fixture;
        test::SyntheticSeries series;
        series.fileName = [](int k) { return QStringLiteral("%1.dcm").arg(k); };
        test::writeSeries(series, fixture.path("segura"));
        QVERIFY(!ui::MaskImporter::looksLikeMask(fixture.path("segura")));
        QSignalSpy loaded(&fixture.window.opener(), &ui::StudyOpener::loaded);
        QSignalSpy failed(&fixture.window.importer(), &ui::MaskImporter::failed);
        fixture.drop(fixture.path("segura"));
        QTRY_COMPARE(loaded.size(), 1);
        QCOMPARE(loaded[0][1].toString(), fixture.path("segura"));

        core::VolumeGeometry geometry = fixture.workspace.volume()->geometry;
        std::vector<std::int16_t> values;
        for (std::size_t voxel = 0; voxel < geometry.voxelCount(); ++voxel)
            values.push_back(std::int16_t(voxel % 1000));
        const QString image = fixture.path("x_masked.nii.gz");
        QVERIFY(core::writeNifti(image, {.geometry = geometry, .voxels = values}));
        fixture.drop(image);
        QTRY_COMPARE(loaded.size(), 2);
        QCOMPARE(loaded[1][1].toString(), image);
        QCOMPARE(failed.size(), 0);
        QVERIFY(fixture.session().history().rows().empty());
        // Who imports it by the menu is told.
        fixture.window.importer().import(image);
        fixture.finish();
        QCOMPARE(failed.size(), 1);
        QCOMPARE(loaded.size(), 2);
    }

    /// A file for each structure, as networks write them.
    void aFolderOfMasksIsOneStep()
    {
        ImportFixture fixture;
        QVERIFY(QDir(fixture.folder.path()).mkdir(QStringLiteral("segmentations")));
        for (const char* name : {"segmentations/liver.nii", "segmentations/spleen.nii"})
            QVERIFY(!fixture.mask(name).isEmpty());
        fixture.drop(fixture.path("segmentations"));
        QTRY_VERIFY(fixture.window.findChild<ui::MaskOrderDialog*>());
        auto* dialog = fixture.window.findChild<ui::MaskOrderDialog*>();
        dialog->accept();
        fixture.finish();
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(1));
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(4));
        QCOMPARE(fixture.session().document().labelPlanes().size(), std::size_t(2));
        // One that says nothing of masks is a study.
        QVERIFY(!ui::MaskImporter::looksLikeMask(fixture.folder.path()));
        QVERIFY(QDir(fixture.folder.path()).mkdir(QStringLiteral("masks")));
        QVERIFY(!ui::MaskImporter::looksLikeMask(fixture.path("masks"))); // none in it
    }

    void anotherGridIsTold()
    {
        ImportFixture fixture;
        QSignalSpy imported(&fixture.window.importer(), &ui::MaskImporter::imported);
        fixture.window.importer().import(fixture.mask("moved.nii", {0.7, 0.0, 0.0}));
        fixture.finish();
        QCOMPARE(imported.count(), 1);
        QVERIFY(!imported[0][1].toStringList().isEmpty());
        QVERIFY(
            fixture.window.messages().sentence().contains(imported[0][1].toStringList().first()));
    }

    void whatCannotBeReadIsSaidAndNothingChanges_data()
    {
        QTest::addColumn<bool>("outside");
        QTest::newRow("no mask") << false;
        QTest::newRow("wholly outside") << true;
    }
    void whatCannotBeReadIsSaidAndNothingChanges()
    {
        QFETCH(bool, outside);
        ImportFixture fixture;
        QString file = fixture.path("none.nii");
        if (outside) {
            file = fixture.mask("far.nii", {5000.0, 0.0, 0.0});
        } else {
            QFile bytes(file);
            QVERIFY(bytes.open(QIODevice::WriteOnly) && bytes.write("no mask at all") > 0);
        }
        QSignalSpy failed(&fixture.window.importer(), &ui::MaskImporter::failed);
        fixture.window.importer().import(file);
        fixture.finish();
        QCOMPARE(failed.count(), 1);
        QVERIFY(fixture.session().history().rows().empty());
        const QString sentence = fixture.window.messages().sentence();
        QVERIFY2(
            sentence.contains(outside ? QStringLiteral("far.nii") : QStringLiteral("none.nii")),
            qPrintable(sentence));
    }

    /// Nothing that the window is told of changes when an import is refused.
    void whoeverOpensTheMenuMayTryAgain()
    {
        ImportFixture fixture;
        QMenu& menu = fixture.window.fileMenu();
        QAction& import = fixture.window.actionTable()[QStringLiteral("file.importMask")];
        fixture.window.importer().import(fixture.mask("far.nii", {5000.0, 0.0, 0.0}));
        Q_EMIT menu.aboutToShow();
        QVERIFY(!import.isEnabled()); // one at a time
        fixture.finish();
        Q_EMIT menu.aboutToShow();
        QVERIFY(import.isEnabled());
    }

    void whatIsLikeAMask()
    {
        ImportFixture fixture;
        QVERIFY(ui::MaskImporter::looksLikeMask(QStringLiteral("/a/b.seg.nrrd")));
        QVERIFY(ui::MaskImporter::looksLikeMask(QStringLiteral("/a/Labels.nii.gz")));
        QVERIFY(!ui::MaskImporter::looksLikeMask(QStringLiteral("/a/brain.nii.gz")));
        QVERIFY(!ui::MaskImporter::looksLikeMask(fixture.folder.path()));
    }
};

BURIN_WINDOW_TEST(MaskImporterUiTest)

} // namespace maskImporterUiTest

#include "MaskImporterUiTest.moc"
