// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/MaskTexts.h"

#include "core/titles/TitleLanguage.h"
#include "ui/texts/ProblemTexts.h"

#include <QCoreApplication>

namespace ui {

namespace {

struct MaskTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::MaskTexts)
};

QString grouped(std::uint64_t count)
{
    return core::grouped(std::int64_t(count));
}

QString inMl(double ml)
{
    return MaskTexts::tr("%1 mL").arg(QString::number(ml, 'f', ml < 1.0 ? 3 : 1));
}

} // namespace

QString maskNoteText(const core::MaskNote& note)
{
    using Code = core::MaskNote::Code;
    const QString names = note.names.join(MaskTexts::tr(", "));
    switch (note.code) {
    case Code::AnotherGrid:
        return MaskTexts::tr("The mask lies on another grid than the study: each voxel has what "
                             "the mask's nearest voxel has; %1 there are %2 here.")
            .arg(inMl(note.fileMl), inMl(note.hereMl));
    case Code::OutsideStudy:
        return MaskTexts::tr("%1 of the mask's %2 voxels lie outside the study and are left out.")
            .arg(grouped(note.some), grouped(note.all));
    case Code::AnotherPatient:
        return MaskTexts::tr("The mask names another patient than the study.");
    case Code::AnotherFrameOfReference:
        return MaskTexts::tr("The mask names another frame of reference than the study; its "
                             "millimetres are taken for the study's.");
    case Code::SegmentsOverlap:
        return MaskTexts::tr("Segments overlap in %1 voxels.").arg(grouped(note.some));
    case Code::GoesBefore:
        return MaskTexts::tr("'%1' goes before '%2' in %3 voxels (%4) that both have.")
            .arg(note.names.value(0), note.names.value(1), grouped(note.some), inMl(note.hereMl));
    case Code::OverlapsKept:
        return MaskTexts::tr("Each segment keeps its voxels; the segments lie in %1 label planes.")
            .arg(note.some);
    case Code::SegmentsWithoutVoxel:
        return MaskTexts::tr("%1 of the file's %2 segments have no voxel inside the study and are "
                             "left out.")
            .arg(note.some)
            .arg(note.all);
    case Code::ImagesLeftOut:
        return MaskTexts::tr("Left out, since their values are those of images: %1.").arg(names);
    case Code::SlicesLeftOut:
        return MaskTexts::tr("%1 DICOM files of the folder are images and are left out.")
            .arg(grouped(note.some));
    case Code::FilesWithoutVoxel:
        return MaskTexts::tr("%1 of the folder's %2 mask files have no voxel inside the study and "
                             "are left out.")
            .arg(note.some)
            .arg(note.all);
    case Code::NothingSurrounded:
        return MaskTexts::tr("Left out, since they surround no voxel here: %1.").arg(names);
    case Code::Fractional:
        return MaskTexts::tr("The mask says how much of each voxel belongs to a segment; voxels "
                             "with one half or more are taken.");
    case Code::MapOnAnotherGrid:
        return MaskTexts::tr("The probability map has another grid than the study; each voxel "
                             "takes the nearest one's probability.");
    case Code::BetweenSlices:
        return MaskTexts::tr("Its contours lie between the study's slices: each slice has what the "
                             "nearest contours, at most %1 mm away, surround.")
            .arg(note.mm, 0, 'g', 4);
    case Code::OpenContours:
        return MaskTexts::tr("Points and open curves of '%1' are left out.").arg(names);
    case Code::UnnamedAxes:
        return MaskTexts::tr("The file does not name its axes; they are taken for those of DICOM "
                             "(LPS), its numbers for millimetres.");
    case Code::TwoFaced:
        return MaskTexts::tr("Triangles of '%1' do not all look outwards: inside is what an odd "
                             "number of them lies around.")
            .arg(names);
    case Code::Enclosed:
        return MaskTexts::tr("'%1' encloses %2; the voxels with their centres inside are %3.")
            .arg(names, inMl(note.fileMl), inMl(note.hereMl));
    case Code::GridInDoubt:
        return problemText(note.doubt);
    }
    return {};
}

} // namespace ui
