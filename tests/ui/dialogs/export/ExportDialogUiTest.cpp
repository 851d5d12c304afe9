// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SegReader.h"
#include "core/session/SessionDisplay.h"
#include "ui/dialogs/export/ExportDialog.h"
#include "ui/dialogs/export/SuggestedTarget.h"

#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/series/SmallSeries.h"
#include "ui/base/Theme.h"
#include "ui/texts/ExportFormatTexts.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QCryptographicHash>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>
#include <QtTest>

namespace exportDialogUiTest {

namespace {

QString text(const char* latin)
{
    return QLatin1String(latin);
}

const core::CodedConcept skull{
    QStringLiteral("SCT"), QStringLiteral("89546000"), QStringLiteral("Skull")};

/// A DICOM series on disk with three segments: "Grown" has voxels, "Hidden" too, "Empty" has none.
class ExportFixture {
public:
    ExportFixture()
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
        apply(core::AddSegment{text("Grown"), 0x4a9bff, {}});
        apply(core::AddSegment{text("Hidden"), 0x5bc07c, skull});
        apply(core::AddSegment{text("Empty"), 0xf0b04a, skull});
        seed(1, {2, 2, 2});
        seed(2, {9, 7, 4});
        const core::Volume& volume = *workspace.volume();
        apply(test::growBetween(volume.encoding.value(0) - 1.0, volume.encoding.value(0) + 1.0, 2));
        session().display().setSegmentVisible(2, false);
        // The engine's wake-up, as the program has it.
        QObject::connect(&wakeUp, &QTimer::timeout, [this] { session().poll(); });
        wakeUp.start(1);
    }
    [[nodiscard]] core::EditSession& session() { return *workspace.session(); }
    void apply(const core::Edit& edit)
    {
        if (!session().apply(edit) || !session().settle())
            qFatal("an edit of the fixture failed");
    }
    void seed(int segment, const glm::dvec3& index)
    {
        apply(test::seedAt(segment, {workspace.volume()->geometry.toWorld(index)}));
    }
    [[nodiscard]] QString path(const char* name) const { return folder.filePath(text(name)); }

    QTemporaryDir folder;
    reference::ReferenceEngine engine;
    test::NoFrames frames;
    ui::Workspace workspace;
    QTimer wakeUp;
};

QTreeWidgetItem& row(const ui::ExportDialog& dialog, const char* name)
{
    auto* tree = dialog.findChild<QTreeWidget*>(text("exportSegments"));
    const auto found = tree->findItems(text(name), Qt::MatchExactly, 0);
    if (found.size() != 1)
        qFatal("no row %s", name);
    return *found.front();
}

QAbstractButton& button(const ui::ExportDialog& dialog, const char* name)
{
    return *dialog.findChild<QAbstractButton*>(text(name));
}

int rowOf(const ui::ExportDialog& dialog, core::ExportFormat format)
{
    return dialog.findChild<QComboBox*>(text("exportFormat"))->findData(int(format));
}

bool isPossible(const ui::ExportDialog& dialog, core::ExportFormat format)
{
    const auto* model = dialog.findChild<QComboBox*>(text("exportFormat"))->model();
    return model->flags(model->index(rowOf(dialog, format), 0)).testFlag(Qt::ItemIsEnabled);
}

void choose(const ui::ExportDialog& dialog, core::ExportFormat format)
{
    dialog.findChild<QComboBox*>(text("exportFormat"))->setCurrentIndex(rowOf(dialog, format));
}

void answer(QMessageBox::StandardButton with)
{
    QTimer::singleShot(0, qApp, [with] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box)
            qFatal("nothing is asked");
        box->button(with)->click();
    });
}

} // namespace

class ExportDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_settings.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        ui::theme::apply(*qApp);
    }

    /// Each format says in its own words what it is; no letter is lost on the way.
    void saysWhatFormatsAre()
    {
        ExportFixture fixture;
        ui::ExportDialog dialog(fixture.workspace);
        const auto* says = dialog.findChild<QLabel*>(text("exportSays"));
        for (const core::ExportFormatFacts& facts : core::exportFormats()) {
            choose(dialog, facts.format);
            QVERIFY2(says->text().startsWith(ui::exportFormatSays(facts.format)),
                qPrintable(says->text()));
        }
    }

    void ticksAllOrNone()
    {
        ExportFixture fixture;
        ui::ExportDialog dialog(fixture.workspace);
        const auto* ticked = dialog.findChild<QLabel*>(text("exportTicked"));
        QVERIFY2(ticked->text().startsWith(text("1 of 3")), qPrintable(ticked->text()));
        button(dialog, "exportAll").click();
        // What is empty has nothing to export.
        QVERIFY2(ticked->text().startsWith(text("2 of 3")), qPrintable(ticked->text()));
        QCOMPARE(row(dialog, "Hidden").checkState(0), Qt::Checked);
        QCOMPARE(row(dialog, "Empty").checkState(0), Qt::Unchecked);
        button(dialog, "exportNone").click();
        QVERIFY2(ticked->text().startsWith(text("0 of 3")), qPrintable(ticked->text()));
        QVERIFY(!button(dialog, "exportStart").isEnabled());
    }

    void saysWhoseStudyAndWhatIsInIt()
    {
        ExportFixture fixture;
        ui::ExportDialog dialog(fixture.workspace);
        const QString patient = dialog.findChild<QLabel*>(text("exportPatient"))->text();
        QVERIFY2(patient.contains(text("P-0815")), qPrintable(patient));
        QVERIFY2(patient.contains(text("1950-01-02")), qPrintable(patient));

        QCOMPARE(row(dialog, "Grown").checkState(0), Qt::Checked);
        QCOMPARE(row(dialog, "Hidden").checkState(0), Qt::Unchecked);
        QCOMPARE(row(dialog, "Empty").checkState(0), Qt::Unchecked);
        QVERIFY(row(dialog, "Grown").text(1).endsWith(text("mL")));
        QVERIFY(row(dialog, "Grown").text(3).contains(text("not coded yet")));
        QVERIFY(row(dialog, "Grown").text(3).contains(text("growth not finished")));
        QVERIFY(row(dialog, "Hidden").text(3).contains(text("hidden")));
        QVERIFY(row(dialog, "Empty").text(3).contains(text("empty")));
        QCOMPARE(row(dialog, "Hidden").text(2), text("Skull"));
    }

    void segRefusesWhatIsNotCoded()
    {
        ExportFixture fixture;
        ui::ExportDialog dialog(fixture.workspace);
        QVERIFY(isPossible(dialog, core::ExportFormat::DicomSeg));
        QVERIFY(!button(dialog, "exportStart").isEnabled());
        QVERIFY(dialog.findChild<QLabel*>(text("exportState"))->text().contains(text("Grown")));
        choose(dialog, core::ExportFormat::Nifti);
        QVERIFY(button(dialog, "exportStart").isEnabled());
        QVERIFY(dialog.findChild<QLineEdit*>(text("exportFile"))->text().endsWith(text(".nii.gz")));
        choose(dialog, core::ExportFormat::SegNrrd);
        QVERIFY(button(dialog, "exportStart").isEnabled());
        const auto* named = dialog.findChild<QLineEdit*>(text("exportFile"));
        QVERIFY2(named->text().endsWith(text("Grown.seg.nrrd")), qPrintable(named->text()));
        choose(dialog, core::ExportFormat::Nifti);
        QVERIFY2(named->text().endsWith(text("Grown.nii.gz")), qPrintable(named->text()));
        choose(dialog, core::ExportFormat::DicomSeg);
        QVERIFY(dialog.findChild<QLineEdit*>(text("exportFile"))->text().endsWith(text(".dcm")));
        // Coding it, by whatever way, is seen at once; the ticks stay.
        row(dialog, "Hidden").setCheckState(0, Qt::Checked);
        fixture.apply(core::ChangeSegment{1, {}, {}, skull});
        QVERIFY(button(dialog, "exportStart").isEnabled());
        QCOMPARE(row(dialog, "Hidden").checkState(0), Qt::Checked);
        QCOMPARE(row(dialog, "Grown").text(2), text("Skull"));
        for (const char* name : {"Grown", "Hidden"})
            row(dialog, name).setCheckState(0, Qt::Unchecked);
        QVERIFY(!button(dialog, "exportStart").isEnabled());
    }

    void writesChecksAndReports_data()
    {
        QTest::addColumn<int>("format");
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("SEG") << int(core::ExportFormat::DicomSeg) << QByteArray("out.dcm");
        QTest::newRow("SEG, fractional")
            << int(core::ExportFormat::DicomSegFractional) << QByteArray("part.dcm");
        QTest::newRow("SEG, label map")
            << int(core::ExportFormat::DicomSegLabelMap) << QByteArray("map.dcm");
        QTest::newRow("NIfTI") << int(core::ExportFormat::Nifti) << QByteArray("out.nii.gz");
        QTest::newRow("RTSTRUCT") << int(core::ExportFormat::RtStruct) << QByteArray("rt.dcm");
        QTest::newRow("STL") << int(core::ExportFormat::Stl) << QByteArray("out.stl");
        QTest::newRow("OBJ") << int(core::ExportFormat::Obj) << QByteArray("out.obj");
        QTest::newRow("PLY") << int(core::ExportFormat::Ply) << QByteArray("out.ply");
        QTest::newRow("glTF") << int(core::ExportFormat::Gltf) << QByteArray("out.glb");
        QTest::newRow("3D Slicer")
            << int(core::ExportFormat::SegNrrd) << QByteArray("out.seg.nrrd");
        QTest::newRow("CSV") << int(core::ExportFormat::Csv) << QByteArray("out.csv");
        QTest::newRow("JSON") << int(core::ExportFormat::Json) << QByteArray("out.json");
        QTest::newRow("SR") << int(core::ExportFormat::Sr) << QByteArray("out-sr.dcm");
    }
    void writesChecksAndReports()
    {
        QFETCH(int, format);
        QFETCH(QByteArray, name);
        ExportFixture fixture;
        fixture.apply(core::ChangeSegment{1, {}, {}, skull});
        ui::ExportDialog dialog(fixture.workspace);
        dialog.show();
        choose(dialog, core::ExportFormat(format));
        const QString file = fixture.path(name.constData());
        dialog.findChild<QLineEdit*>(text("exportFile"))->setText(file);
        QSignalSpy exported(&dialog, &ui::ExportDialog::exported);
        button(dialog, "exportStart").click();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, 60000);
        QVERIFY(QFile::exists(file));
        const QString report = dialog.findChild<QLabel*>(text("exportReport"))->text();
        QVERIFY2(report.contains(QStringLiteral("✓")), qPrintable(report));
        const QByteArray sum =
            QCryptographicHash::hash(test::bytesOf(file), QCryptographicHash::Sha256).toHex();
        QVERIFY2(report.contains(QString::fromLatin1(sum)), qPrintable(report));
        QVERIFY(!dialog.running());
        test::look(dialog.grab(), qPrintable(QStringLiteral("export-%1.png").arg(format)));
        // The verdict is about that file alone.
        const auto* verdict = dialog.findChild<QLabel*>(text("exportReport"));
        QVERIFY(verdict->isVisible());
        dialog.findChild<QLineEdit*>(text("exportFile"))->setText(fixture.path("another"));
        QVERIFY(!verdict->isVisible());
    }

    /// Options of the formats show where they mean something, and reach the file.
    void takesThePatientOut()
    {
        ExportFixture fixture;
        fixture.apply(core::ChangeSegment{1, {}, {}, skull});
        ui::ExportDialog dialog(fixture.workspace);
        dialog.show();
        choose(dialog, core::ExportFormat::Nifti);
        QVERIFY(!button(dialog, "exportDeflated").isVisible());
        choose(dialog, core::ExportFormat::DicomSeg);
        QVERIFY(button(dialog, "exportDeflated").isVisible());
        QVERIFY(!dialog.findChild<QWidget*>(text("deidentifyDates"))->isVisible());
        button(dialog, "deidentify").click();
        QVERIFY(dialog.findChild<QWidget*>(text("deidentifyDates"))->isVisible());
        button(dialog, "exportDeflated").click();
        const QString file = fixture.path("out.dcm");
        dialog.findChild<QLineEdit*>(text("exportFile"))->setText(file);
        QSignalSpy exported(&dialog, &ui::ExportDialog::exported);
        button(dialog, "exportStart").click();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, 60000);
        const QString report = dialog.findChild<QLabel*>(text("exportReport"))->text();
        QVERIFY2(report.contains(text("De-identified")) && report.contains(text("deflated")),
            qPrintable(report));
        const auto seg = core::readSeg(file);
        QVERIFY(seg);
        QCOMPARE(seg->patient.name, text("Anonymous"));
        QVERIFY(seg->studyUid != fixture.workspace.volume()->identity.studyUid);
        QCOMPARE(seg->segments.front().label, text("Skull"));
        test::look(dialog.grab(), "export-deidentified.png");
    }

    void asksBeforeItReplaces()
    {
        ExportFixture fixture;
        const QString path = fixture.path("there.nii.gz");
        QFile there(path);
        QVERIFY(there.open(QIODevice::WriteOnly) && there.write("mine") == 4);
        there.close();
        ui::ExportDialog dialog(fixture.workspace);
        dialog.show();
        choose(dialog, core::ExportFormat::Nifti);
        dialog.findChild<QLineEdit*>(text("exportFile"))->setText(path);
        QSignalSpy exported(&dialog, &ui::ExportDialog::exported);
        answer(QMessageBox::No);
        button(dialog, "exportStart").click();
        QVERIFY(!dialog.running());
        QCOMPARE(test::bytesOf(path), QByteArray("mine"));
        answer(QMessageBox::Yes);
        button(dialog, "exportStart").click();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, 60000);
        QVERIFY(test::bytesOf(path) != QByteArray("mine"));
    }

    void writesNothingOfASessionThatIsClosedWhileItAsks()
    {
        ExportFixture fixture;
        const QString path = fixture.path("there.nii.gz");
        QFile there(path);
        QVERIFY(there.open(QIODevice::WriteOnly) && there.write("mine") == 4);
        there.close();
        ui::ExportDialog dialog(fixture.workspace);
        dialog.show();
        choose(dialog, core::ExportFormat::Nifti);
        dialog.findChild<QLineEdit*>(text("exportFile"))->setText(path);
        QTimer::singleShot(0, qApp, [&fixture] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box)
                qFatal("nothing is asked");
            fixture.wakeUp.stop();
            fixture.workspace.setSession(nullptr);
            box->button(QMessageBox::Yes)->click();
        });
        button(dialog, "exportStart").click();
        QVERIFY(!fixture.workspace.session());
        QVERIFY(!dialog.running());
        QCOMPARE(test::bytesOf(path), QByteArray("mine"));
    }

    /// While the engine does not answer the window goes on, and the export can be given up.
    void neverWaitsForTheEngine()
    {
        ExportFixture fixture;
        fixture.wakeUp.stop();
        ui::ExportDialog dialog(fixture.workspace);
        dialog.show();
        choose(dialog, core::ExportFormat::Nifti);
        const QString file = fixture.path("out.nii.gz");
        dialog.findChild<QLineEdit*>(text("exportFile"))->setText(file);
        QSignalSpy exported(&dialog, &ui::ExportDialog::exported);
        button(dialog, "exportStart").click();
        QVERIFY(dialog.running());
        QTest::qWait(30); // it goes on waiting, of which nothing tells
        QVERIFY(dialog.running());
        const auto* state = dialog.findChild<QLabel*>(text("exportState"));
        QCOMPARE(state->text(), text("Reading the segments"));
        QVERIFY(!dialog.findChild<QTreeWidget*>()->isEnabled());
        dialog.close();
        QVERIFY(dialog.isVisible());
        QVERIFY(!dialog.running());
        QVERIFY2(state->text().contains(text("aborted")), qPrintable(state->text()));
        QVERIFY(button(dialog, "exportStart").isEnabled());
        // What the engine answers late is dropped; the next export is whole.
        fixture.wakeUp.start(1);
        QVERIFY(fixture.session().settle());
        QCoreApplication::sendPostedEvents();
        QVERIFY(!dialog.running());
        QVERIFY(!QFile::exists(file));
        button(dialog, "exportStart").click();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, 60000);
        QVERIFY(QFile::exists(file));
    }

    void endsWithItsStudy()
    {
        ExportFixture fixture;
        fixture.wakeUp.stop();
        ui::ExportDialog dialog(fixture.workspace);
        dialog.show();
        choose(dialog, core::ExportFormat::Nifti);
        dialog.findChild<QLineEdit*>(text("exportFile"))->setText(fixture.path("out.nii.gz"));
        button(dialog, "exportStart").click();
        QVERIFY(dialog.running());
        fixture.workspace.setSession(nullptr);
        QVERIFY(!dialog.isVisible());
        QVERIFY(!dialog.running());
    }

    /// It is named after study and segments, beside the study, until the user says otherwise.
    void theFileIsNamedAfterWhatIsInIt()
    {
        QSettings().remove(text("export/folder"));
        ExportFixture fixture;
        QTemporaryDir place;
        core::Volume volume = *fixture.workspace.volume();
        volume.sourcePath = place.filePath(text("study"));
        QCOMPARE(ui::folderBeside(volume, text("else")), place.filePath(text("Burin exports")));
        volume.sourcePath = text("/no/such/place/study");
        QCOMPARE(ui::folderBeside(volume, text("else")), text("else"));
        volume.sourcePath.clear();
        QCOMPARE(ui::folderBeside(volume, text("else")), text("else"));

        core::StudyIdentity identity;
        identity.patientName = text("DOE^JANE");
        identity.modality = text("CT");
        identity.studyDate = text("2026-11-20");
        identity.seriesNumber = text("3");
        const std::vector<core::Segment> all = fixture.session().document().segments;
        QCOMPARE(ui::exportName(identity, all, true),
            text("CT 2026-11-20 series 3 - Grown, Hidden, Empty"));
        QCOMPARE(ui::exportName(identity, {all[0]}, false), text("CT series 3 - Grown"));
        QCOMPARE(ui::exportName({}, QString(), true), text("segmentation"));
        core::Segment odd = all[0];
        odd.name = text("../a\\b: c*");
        QCOMPARE(ui::exportName({}, {odd}, true), text("___a_b_ c_"));
        std::vector<core::Segment> many(5, all[0]);
        QCOMPARE(ui::exportName({}, many, true), text("Grown, Grown, Grown and 2 more"));

        ui::ExportDialog dialog(fixture.workspace);
        choose(dialog, core::ExportFormat::Nifti);
        auto* file = dialog.findChild<QLineEdit*>(text("exportFile"));
        QVERIFY2(file->text().endsWith(text("Grown.nii.gz")), qPrintable(file->text()));
        row(dialog, "Hidden").setCheckState(0, Qt::Checked);
        QVERIFY2(file->text().endsWith(text("Grown, Hidden.nii.gz")), qPrintable(file->text()));
        const QString own = fixture.path("mine.nii.gz");
        file->setText(own);
        row(dialog, "Hidden").setCheckState(0, Qt::Unchecked);
        QCOMPARE(file->text(), own);
    }

    /// The folder beside the study is made; it is offered again, and not remembered for others.
    void theFolderIsMade()
    {
        QSettings().remove(text("export/folder"));
        ExportFixture fixture;
        const QString beside = ui::folderBeside(*fixture.workspace.volume(), QString());
        QVERIFY(!beside.isEmpty() && !QFile::exists(beside));
        ui::ExportDialog dialog(fixture.workspace);
        dialog.show();
        choose(dialog, core::ExportFormat::Nifti);
        const QString file = dialog.findChild<QLineEdit*>(text("exportFile"))->text();
        QVERIFY2(file.startsWith(beside + QLatin1Char('/')), qPrintable(file));
        QVERIFY(!QFile::exists(beside)); // not before it is needed
        button(dialog, "exportStart").click();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.running(), 60000);
        QVERIFY2(QFile::exists(file), qPrintable(file));
        QVERIFY(!QSettings().contains(text("export/folder")));
    }

    void aFailureIsOneSentence()
    {
        ExportFixture fixture;
        ui::ExportDialog dialog(fixture.workspace);
        dialog.show();
        choose(dialog, core::ExportFormat::Nifti);
        const QString file = fixture.path("no such folder/out.nii.gz");
        dialog.findChild<QLineEdit*>(text("exportFile"))->setText(file);
        button(dialog, "exportStart").click();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.running(), 60000);
        const auto* state = dialog.findChild<QLabel*>(text("exportState"));
        QVERIFY(state->text().contains(text("no such folder")));
        QCOMPARE(state->property("role").toString(), text("bad"));
        test::look(dialog.grab(), "export-failed.png");
        QVERIFY(button(dialog, "exportStart").isEnabled());
    }

private:
    QTemporaryDir m_settings;
};

BURIN_WINDOW_TEST(ExportDialogUiTest)

} // namespace exportDialogUiTest

#include "ExportDialogUiTest.moc"
