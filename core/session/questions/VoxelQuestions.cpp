// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/VoxelQuestions.h"

#include "core/base/Guarded.h"
#include "core/brick/ThreadWithoutVoxels.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/engine/EngineCommands.h"
#include "core/session/past/LabelReader.h"
#include "core/session/questions/QuestionLine.h"
#include "core/session/questions/TouchSearch.h"

#include <utility>

namespace core {

namespace {

/// Answers with one part of the engine's result.
template <class T>
QuestionLine::Answer answerWith(T EngineResult::*part, VoxelQuestions::Answer<T> answer)
{
    return [part, answer = std::move(answer)](EngineResult&& result) {
        if (result.error)
            answer(tl::unexpected(*std::move(result.error)));
        else
            answer(std::move(result.*part));
    };
}

/// Answers with the bricks that were read.
QuestionLine::Answer answerWithBricks(VoxelQuestions::Answer<std::vector<BrickImage>> answer)
{
    return [answer = std::move(answer)](EngineResult&& result) {
        if (result.error)
            return answer(tl::unexpected(*std::move(result.error)));
        std::vector<BrickImage> values;
        values.reserve(result.changes.size());
        for (BrickChange& brick : result.changes)
            values.push_back({.key = brick.key, .bytes = std::move(brick.after)});
        answer(std::move(values));
    };
}

void ignore(EngineResult&&) { }

} // namespace

VoxelQuestions::VoxelQuestions(QuestionLine& line, const glm::ivec3& volumeSize)
    : m_line(line)
    , m_volumeSize(volumeSize)
    , m_readings(std::make_shared<int>())
{
}

void VoxelQuestions::probe(
    std::vector<glm::ivec3> voxels, Answer<std::vector<ProbedVoxel>> answer, std::uint8_t plane)
{
    m_line.ask(ProbeVoxels{.voxels = std::move(voxels), .plane = plane},
        answerWith(&EngineResult::probes, std::move(answer)));
}

void VoxelQuestions::pick(
    PickQuestion question, Answer<std::vector<std::optional<glm::ivec3>>> answer)
{
    m_line.ask(PickVoxels{.rays = std::move(question.rays),
                   .seenBy = question.seenBy,
                   .thresholdCode = question.thresholdCode,
                   .opacityOfCode = std::move(question.opacityOfCode),
                   .segments = question.segments},
        answerWith(&EngineResult::picks, std::move(answer)));
}

void VoxelQuestions::codes(const VoxelBox& box, Answer<std::vector<std::uint16_t>> answer)
{
    m_line.ask(ReadCodes{box}, answerWith(&EngineResult::codes, std::move(answer)));
}

void VoxelQuestions::bricks(std::vector<BrickKey> keys, Answer<std::vector<BrickImage>> answer)
{
    m_line.ask(ReadBricks{std::move(keys)}, answerWithBricks(std::move(answer)));
}

void VoxelQuestions::barriers(std::uint8_t plane, Answer<std::vector<BrickImage>> answer)
{
    m_line.ask(ReadBarriers{.plane = plane}, answerWithBricks(std::move(answer)));
}

bool VoxelQuestions::readOn(const std::shared_ptr<LabelReader>& reader, Answer<void> answer)
{
    std::optional<ReadBricks> portion = reader->next();
    if (!portion)
        return false;
    m_line.ask(*std::move(portion), [reader, answer = std::move(answer)](EngineResult&& result) {
        answer(reader->take(result));
    });
    return true;
}

void VoxelQuestions::seedSums(std::uint8_t plane, const CodeInterval& interval,
    std::vector<SeedGroup> strokes, Answer<std::vector<ProbedSeeds>> answer)
{
    m_line.ask(ProbeSeeds{.plane = plane,
                   .lowCode = interval.low,
                   .highCode = interval.high,
                   .seedGroups = std::move(strokes)},
        answerWith(&EngineResult::seeds, std::move(answer)));
}

void VoxelQuestions::generationSizes(std::uint8_t plane, Answer<std::vector<std::uint32_t>> answer)
{
    m_line.ask(CountGenerations{.plane = plane},
        answerWith(&EngineResult::generationSizes, std::move(answer)));
}

void VoxelQuestions::traceTolerance(
    const ToleranceRule& rule, Answer<std::optional<ToleranceCurve>> answer)
{
    m_line.ask(TraceTolerance{.rule = rule, .toTheEnd = false},
        answerWith(&EngineResult::tolerance, std::move(answer)));
}

void VoxelQuestions::dropTolerance()
{
    m_line.ask(DropTolerance{}, ignore);
}

Result<void> VoxelQuestions::previewCut(
    const ShrinkAt& shrink, Answer<std::optional<CutPreview>> answer)
{
    Result<CutGrowth> cut = cutGrowth(shrink, m_line.foreseen());
    if (!cut)
        return tl::unexpected(cut.error());
    m_line.ask(PreviewCut{.cut = *std::move(cut), .toTheEnd = false},
        answerWith(&EngineResult::cutPreview, std::move(answer)));
    return {};
}

void VoxelQuestions::dropCutPreview()
{
    m_line.ask(DropCutPreview{}, ignore);
}

void VoxelQuestions::compareGrowth(Answer<std::optional<GrowthComparison>> answer, bool keep)
{
    m_line.ask(CompareGrowth{.keep = keep},
        answerWith(&EngineResult::growthComparison, std::move(answer)));
}

void VoxelQuestions::lastTouching(const Touch& touch, std::function<void(RowId)> answer)
{
    m_line.closeOpen();
    m_line.submit(std::make_unique<TouchSearch>(touch, std::move(answer)));
}

void VoxelQuestions::afterAll(std::function<void()> then)
{
    // Probing nothing costs nothing and takes its place in line.
    m_line.ask(ProbeVoxels{}, [then = std::move(then)](EngineResult&&) { then(); });
}

Result<std::vector<std::uint8_t>> VoxelQuestions::labels(std::uint8_t plane)
{
    return guarded([&] { return read(plane, Field::Labels); });
}

Result<std::vector<std::uint8_t>> VoxelQuestions::coverage(std::uint8_t layer)
{
    return guarded([&] { return read(layer, Field::Coverage); });
}

Result<std::vector<std::uint8_t>> VoxelQuestions::read(std::uint8_t plane, Field field)
{
    const auto reader = std::make_shared<LabelReader>(m_volumeSize, plane, field);
    // Shared with the answer: if waiting throws, the answer may still come.
    const auto taken = std::make_shared<std::optional<Result<void>>>();
    while (readOn(reader, [taken](const Result<void>& portion) { *taken = portion; })) {
        while (!*taken)
            m_line.waitForEngine();
        if (!**taken)
            return tl::unexpected((*taken)->error());
        taken->reset();
    }
    const VoxelsAllowed allowed; // the caller waits for the labels anyway
    return reader->takeLabels();
}

} // namespace core
