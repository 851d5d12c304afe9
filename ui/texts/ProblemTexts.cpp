// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ProblemTexts.h"

#include "ui/texts/ClauseText.h"

#include <QCoreApplication>

namespace ui {

namespace {

struct ProblemTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::ProblemTexts)
};

using core::ProblemCode;

/// A code without a form does not compile.
QString formOf(ProblemCode code, std::int64_t count)
{
    switch (code) {
    case ProblemCode::AsStored:
        return QStringLiteral("%1");
    case ProblemCode::Comma:
        return ProblemTexts::tr(", ");
    case ProblemCode::Semicolon:
        return ProblemTexts::tr("; ");
    case ProblemCode::AndOf:
        return ProblemTexts::tr(" and of ");
    case ProblemCode::OneSlice:
        return ProblemTexts::tr("slice %1");
    case ProblemCode::Slices:
        return ProblemTexts::tr("slices %1");
    case ProblemCode::MoreThanVoxels:
        return ProblemTexts::tr(
            "The file holds more than the voxels that its header tells of; the rest is left out.");
    case ProblemCode::AxesAssumed:
        return ProblemTexts::tr("The file does not say how it lies in the patient; its axes are "
                                "taken for left, posterior and superior.");
    case ProblemCode::SidesAssumed:
        return ProblemTexts::tr(
            "The file does not say how it lies in the patient; left and right are assumed.");
    case ProblemCode::OriginAssumed:
        return ProblemTexts::tr("The file does not say where in its space it begins; its first "
                                "voxel is put at 0, 0, 0.");
    case ProblemCode::SpacingAssumed:
        return ProblemTexts::tr(
            "The file does not say how far apart its voxels are; 1 mm is assumed.");
    case ProblemCode::ThicknessAssumed:
        return ProblemTexts::tr(
            "The file does not say how thick its only slice is; 1 mm is assumed.");
    case ProblemCode::DepthAssumed:
        return ProblemTexts::tr(
            "A single image: its depth of %1 mm is assumed from nothing in the file.");
    case ProblemCode::DepthTakenFrom:
        return ProblemTexts::tr("A single image: its depth of %1 mm is assumed from %2.");
    case ProblemCode::PicturesWithoutSpacing:
        return ProblemTexts::tr("The pictures do not say how far apart their voxels are.");
    case ProblemCode::PicturesWithoutDistance:
        return ProblemTexts::tr("The pictures do not say how far apart they are; within them "
                                "voxels of %1 × %2 mm are named.");
    case ProblemCode::PicturesWithoutAxes:
        return ProblemTexts::tr("Pictures do not say how they lie in the patient; columns are "
                                "taken to run to the left, rows to posterior, slices to superior.");
    case ProblemCode::PicturesTurned:
        return ProblemTexts::tr(
            "The pictures are marked to be shown turned or mirrored; they are taken as they lie.");
    case ProblemCode::NumbersMissing:
        return ProblemTexts::tr("Numbers are missing in the names of the files: %1. The slices are "
                                "taken to follow each other at equal distances all the same.");
    case ProblemCode::NumbersMissingBetween:
        return ProblemTexts::tr("%1 between %2 and %3");
    case ProblemCode::AtMorePlaces:
        return ProblemTexts::tr("and at %1 more places");
    case ProblemCode::PictureLeftEmpty:
        return ProblemTexts::tr("Slice %1 (%2) could not be read: %3. It is left empty.");
    case ProblemCode::SlicesMissing:
        return count == 1 ? ProblemTexts::tr("1 slice is missing: %2.")
                          : ProblemTexts::tr("%1 slices are missing: %2.", nullptr, int(count));
    case ProblemCode::SlicesMissingBetween:
        return ProblemTexts::tr("%1 between slices %2 and %3 (%4 mm instead of %5)");
    case ProblemCode::DistancesVary:
        return ProblemTexts::tr("The distance between slices varies from %1 to %2 mm: %3.");
    case ProblemCode::GreatestDistanceBetween:
        return ProblemTexts::tr("it is greatest between slices %1 and %2");
    case ProblemCode::DistanceBetweenSlices:
        return ProblemTexts::tr("%1 mm between slices %2 and %3");
    case ProblemCode::DistanceBetween:
        return ProblemTexts::tr("%1 mm between %2 and %3");
    case ProblemCode::PositionsWander:
        return ProblemTexts::tr("The positions of the slices wander sideways by up to %1 mm.");
    case ProblemCode::SlicesTilted:
        return ProblemTexts::tr(
            "The slices are tilted by %1° against their stacking direction (gantry tilt).");
    case ProblemCode::FramesOfReferenceTakenAsOne:
        return ProblemTexts::tr(
            "Every slice names a frame of reference of its own; they are taken as one.");
    case ProblemCode::DamagedLeftOut:
        return count == 1
            ? ProblemTexts::tr("1 damaged slice was left out: %2.")
            : ProblemTexts::tr("%1 damaged slices were left out: %2.", nullptr, int(count));
    case ProblemCode::UndecodedLeftOut:
        return ProblemTexts::tr("%1. They were left out.");
    case ProblemCode::OneUndecodedLeftOut:
        return ProblemTexts::tr("%1. It was left out.");
    case ProblemCode::FirstUndecoded:
        return ProblemTexts::tr("Slice %1 (%2) could not be decoded: %3");
    case ProblemCode::NextUndecoded:
        return ProblemTexts::tr("slice %1 (%2) could not be decoded: %3");
    case ProblemCode::UndecodedMore:
        return ProblemTexts::tr("and %1 more");
    case ProblemCode::DuplicatesLeftOut:
        return count == 1
            ? ProblemTexts::tr("1 duplicate file was left out, of %2.")
            : ProblemTexts::tr("%1 duplicate files were left out, of %2.", nullptr, int(count));
    case ProblemCode::ContradictingLeftOut:
        return ProblemTexts::tr(
            "Files with the identity of another but other content were left out: %1 (%2).");
    case ProblemCode::PointInTime:
        return ProblemTexts::tr(
            "%1 images lie at every position, one for each point in time; this is point %2.");
    case ProblemCode::NamedPointInTime:
        return ProblemTexts::tr(
            "%1 images lie at every position, one for each point in time; this is point %2 (%3).");
    case ProblemCode::ToldApartByNumbers:
        return ProblemTexts::tr("%1 Nothing but their instance numbers tells them apart.");
    case ProblemCode::Doubled:
        return ProblemTexts::tr("Up to %1 images lie at one position, not as many at every one (%2 "
                                "of the whole); this is %3.");
    case ProblemCode::Quantities:
        return ProblemTexts::tr("Images of %1 lie at every position; this is the volume of %2.");
    case ProblemCode::SeveralStacks:
        return ProblemTexts::tr("The series holds %1 stacks; this is %2, of %3 slices.");
    case ProblemCode::CompressedWithLoss:
        return ProblemTexts::tr("The images were compressed with loss.");
    case ProblemCode::HighBitTaken:
        return ProblemTexts::tr("The files name bit %1 as the highest of %2 stored bits, which "
                                "cannot be; bit %3 is taken.");
    case ProblemCode::ValuesCutOff:
        return ProblemTexts::tr("Some pixels hold more bits than their files say they store; what "
                                "is beyond is cut off, so that these values may be wrong.");
    case ProblemCode::NoNumbers:
        return ProblemTexts::tr("Some voxels hold no number; they are shown as the minimum.");
    case ProblemCode::CommonScale:
        return ProblemTexts::tr("Values are held on a common scale, off by at most %1.");
    case ProblemCode::CommonScaleInUnit:
        return ProblemTexts::tr("Values are held on a common scale, off by at most %1 %2.");
    }
    return {};
}

class WindowLanguage : public core::SaidLanguage<ProblemCode> {
public:
    [[nodiscard]] QString form(ProblemCode code, std::int64_t count) const override
    {
        return formOf(code, count);
    }
    [[nodiscard]] QString clause(const core::Clause& clause) const override
    {
        return clauseText(clause);
    }
};

} // namespace

QString problemText(const core::ProblemSentence& sentence)
{
    return core::worded(sentence, WindowLanguage());
}

} // namespace ui
