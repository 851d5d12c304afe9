// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ProgressTexts.h"

#include <QCoreApplication>

namespace ui {

namespace {

struct ProgressTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::ProgressTexts)
};

} // namespace

QString progressText(core::ProgressStep step)
{
    using core::ProgressStep;
    switch (step) {
    case ProgressStep::ReadingHeaders:
        return ProgressTexts::tr("Reading headers");
    case ProgressStep::ReadingSlices:
        return ProgressTexts::tr("Reading slices");
    case ProgressStep::ReadingVoxels:
        return ProgressTexts::tr("Reading voxels");
    case ProgressStep::Repairing:
        return ProgressTexts::tr("Repairing");
    case ProgressStep::Unpacking:
        return ProgressTexts::tr("Unpacking");
    case ProgressStep::MakingDemonstration:
        return ProgressTexts::tr("Demonstration study");
    case ProgressStep::CheckingSession:
        return ProgressTexts::tr("Checking the session");
    case ProgressStep::ReadingImages:
        return ProgressTexts::tr("Reading the images");
    case ProgressStep::WritingImages:
        return ProgressTexts::tr("Writing the images");
    case ProgressStep::Searching:
        return ProgressTexts::tr("Searching");
    case ProgressStep::Downloading:
        return ProgressTexts::tr("Downloading");
    case ProgressStep::Sending:
        return ProgressTexts::tr("Sending");
    case ProgressStep::PlacingMask:
        return ProgressTexts::tr("Placing the mask");
    case ProgressStep::FillingSurfaces:
        return ProgressTexts::tr("Filling surfaces");
    case ProgressStep::FittingSurface:
        return ProgressTexts::tr("Fitting the surface");
    case ProgressStep::FetchingValues:
        return ProgressTexts::tr("Fetching the values");
    case ProgressStep::CuttingIntoPieces:
        return ProgressTexts::tr("Cutting into small pieces");
    case ProgressStep::FindingLikelyParts:
        return ProgressTexts::tr("Finding likely parts");
    case ProgressStep::JoiningParts:
        return ProgressTexts::tr("Joining what hangs together");
    case ProgressStep::ColouringChunks:
        return ProgressTexts::tr("Colouring them");
    case ProgressStep::ReshapingSegment:
        return ProgressTexts::tr("Reshaping the segment");
    case ProgressStep::ReadingSourceHeaders:
        return ProgressTexts::tr("Reading source headers");
    case ProgressStep::Measuring:
        return ProgressTexts::tr("Measuring");
    case ProgressStep::TracingContours:
        return ProgressTexts::tr("Tracing contours");
    case ProgressStep::WritingContours:
        return ProgressTexts::tr("Writing contours");
    case ProgressStep::MakingSurfaces:
        return ProgressTexts::tr("Making surfaces");
    case ProgressStep::CheckingFrames:
        return ProgressTexts::tr("Checking frames");
    case ProgressStep::CheckingContours:
        return ProgressTexts::tr("Checking contours");
    case ProgressStep::CheckingSurfaces:
        return ProgressTexts::tr("Checking surfaces");
    }
    return {};
}

} // namespace ui
