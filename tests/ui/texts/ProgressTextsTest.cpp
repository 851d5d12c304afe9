// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ProgressTexts.h"

#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace progressTextsTest {

using core::ProgressStep;

/// What the window says while work that takes long is done.
class ProgressTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void steps()
    {
        const std::vector<std::pair<ProgressStep, const char*>> all{
            {ProgressStep::ReadingHeaders, "Reading headers"},
            {ProgressStep::ReadingSlices, "Reading slices"},
            {ProgressStep::ReadingVoxels, "Reading voxels"},
            {ProgressStep::Repairing, "Repairing"},
            {ProgressStep::Unpacking, "Unpacking"},
            {ProgressStep::MakingDemonstration, "Demonstration study"},
            {ProgressStep::CheckingSession, "Checking the session"},
            {ProgressStep::ReadingImages, "Reading the images"},
            {ProgressStep::WritingImages, "Writing the images"},
            {ProgressStep::Searching, "Searching"},
            {ProgressStep::Downloading, "Downloading"},
            {ProgressStep::Sending, "Sending"},
            {ProgressStep::PlacingMask, "Placing the mask"},
            {ProgressStep::FillingSurfaces, "Filling surfaces"},
            {ProgressStep::FittingSurface, "Fitting the surface"},
            {ProgressStep::FetchingValues, "Fetching the values"},
            {ProgressStep::CuttingIntoPieces, "Cutting into small pieces"},
            {ProgressStep::FindingLikelyParts, "Finding likely parts"},
            {ProgressStep::JoiningParts, "Joining what hangs together"},
            {ProgressStep::ColouringChunks, "Colouring them"},
            {ProgressStep::ReshapingSegment, "Reshaping the segment"},
            {ProgressStep::ReadingSourceHeaders, "Reading source headers"},
            {ProgressStep::Measuring, "Measuring"},
            {ProgressStep::TracingContours, "Tracing contours"},
            {ProgressStep::WritingContours, "Writing contours"},
            {ProgressStep::MakingSurfaces, "Making surfaces"},
            {ProgressStep::CheckingFrames, "Checking frames"},
            {ProgressStep::CheckingContours, "Checking contours"},
            {ProgressStep::CheckingSurfaces, "Checking surfaces"},
        };
        for (const auto& [step, text] : all)
            QCOMPARE(ui::progressText(step), QString::fromUtf8(text));
        const test::MarkingTranslator translator;
        for (const auto& [step, text] : all)
            QCOMPARE(ui::progressText(step), u'<' + QString::fromUtf8(text) + u'>');
    }
};

BURIN_TEST(ProgressTextsTest)

} // namespace progressTextsTest

#include "ProgressTextsTest.moc"
