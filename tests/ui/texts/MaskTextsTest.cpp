// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/MaskTexts.h"

#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <utility>
#include <vector>

namespace maskTextsTest {

using core::MaskNote;

namespace {

/// One note of every code, and the English of it.
std::vector<std::pair<MaskNote, const char*>> notes()
{
    using Code = MaskNote::Code;
    return {
        {{.code = Code::AnotherGrid, .fileMl = 0.5, .hereMl = 12.34},
            "The mask lies on another grid than the study: each voxel has what the mask's nearest "
            "voxel has; 0.500 mL there are 12.3 mL here."},
        {{.code = Code::OutsideStudy, .some = 17, .all = 1234567},
            "17 of the mask's 1 234 567 voxels lie outside the study and are left out."},
        {{.code = Code::AnotherPatient}, "The mask names another patient than the study."},
        {{.code = Code::AnotherFrameOfReference},
            "The mask names another frame of reference than the study; its millimetres are taken "
            "for the study's."},
        {{.code = Code::SegmentsOverlap, .some = 18204}, "Segments overlap in 18 204 voxels."},
        {{.code = Code::GoesBefore,
             .names = {QStringLiteral("A %2"), QStringLiteral("B")},
             .some = 1204,
             .hereMl = 0.0301},
            "'A %2' goes before 'B' in 1 204 voxels (0.030 mL) that both have."},
        {{.code = Code::OverlapsKept, .some = 2},
            "Each segment keeps its voxels; the segments lie in 2 label planes."},
        {{.code = Code::SegmentsWithoutVoxel, .some = 2, .all = 5},
            "2 of the file's 5 segments have no voxel inside the study and are left out."},
        {{.code = Code::ImagesLeftOut, .names = {QStringLiteral("ct %2.nii.gz")}},
            "Left out, since their values are those of images: ct %2.nii.gz."},
        {{.code = Code::SlicesLeftOut, .some = 1202},
            "1 202 DICOM files of the folder are images and are left out."},
        {{.code = Code::FilesWithoutVoxel, .some = 3, .all = 104},
            "3 of the folder's 104 mask files have no voxel inside the study and are left out."},
        {{.code = Code::NothingSurrounded, .names = {QStringLiteral("A"), QStringLiteral("B %1")}},
            "Left out, since they surround no voxel here: A, B %1."},
        {{.code = Code::Fractional},
            "The mask says how much of each voxel belongs to a segment; voxels with one half or "
            "more are taken."},
        {{.code = Code::GridInDoubt, .doubt = {core::ProblemCode::SpacingAssumed}},
            "The file does not say how far apart its voxels are; 1 mm is assumed."},
        {{.code = Code::BetweenSlices, .mm = 1.25},
            "Its contours lie between the study's slices: each slice has what the nearest "
            "contours, at most 1.25 mm away, surround."},
        {{.code = Code::OpenContours, .names = {QStringLiteral("A")}},
            "Points and open curves of 'A' are left out."},
        {{.code = Code::UnnamedAxes},
            "The file does not name its axes; they are taken for those of DICOM (LPS), its numbers "
            "for millimetres."},
        {{.code = Code::TwoFaced, .names = {QStringLiteral("A")}},
            "Triangles of 'A' do not all look outwards: inside is what an odd number of them lies "
            "around."},
        {{.code = Code::Enclosed, .names = {QStringLiteral("%2")}, .fileMl = 1.0, .hereMl = 0.9994},
            "'%2' encloses 1.0 mL; the voxels with their centres inside are 0.999 mL."},
    };
}

} // namespace

/// What is said of a mask that was read.
class MaskTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyNote()
    {
        for (const auto& [note, text] : notes())
            QCOMPARE(ui::maskNoteText(note), QString::fromUtf8(text));
    }

    void everyNoteGoesThroughTheTranslator()
    {
        const test::MarkingTranslator translator;
        for (const auto& [note, text] : notes()) {
            const QString said = ui::maskNoteText(note);
            QVERIFY2(said.startsWith(u'<') && said.endsWith(u'>'), qPrintable(said));
        }
    }
};

BURIN_TEST(MaskTextsTest)

} // namespace maskTextsTest

#include "MaskTextsTest.moc"
