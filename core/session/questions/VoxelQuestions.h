// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/growth/ProbedVoxel.h"
#include "core/growth/Tolerance.h"
#include "core/history/History.h"
#include "core/sculpt/PickRay.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace core {

class LabelReader;
class QuestionLine;
struct ShrinkAt;
struct Touch;

/// Rays, and how each finds what the user sees (the rules stand at PickVoxels, EngineCommands.h).
struct PickQuestion {
    std::vector<PickRay> rays{};
    SeenBy seenBy = SeenBy::Surface;
    int thresholdCode = 0; ///< from which code on voxels are material; for Surface
    std::vector<std::uint32_t> opacityOfCode{}; ///< by code >> 8, 65535ths a sample; for Opacity
};

/// What can be asked of the voxels of a session; nothing here changes any. Answers are given by
/// EditSession::poll() in order with the edits, so they tell what stands behind all that was asked
/// for before; when the session closes, those that are not given yet are dropped. Errors of an
/// answer: InvalidField (places outside the volume, a question that is not sound), OutOfMemory,
/// EngineLost. Where no plane is named, labels and seeds are those of plane 0.
class VoxelQuestions {
public:
    template <class T> using Answer = std::function<void(Result<T>)>;

    /// @param line outlives this
    VoxelQuestions(QuestionLine& line, const glm::ivec3& volumeSize);

    /// What is at each of these voxels.
    void probe(std::vector<glm::ivec3> voxels, Answer<std::vector<ProbedVoxel>> answer);
    /// The voxel that is seen along each ray; none: nothing is.
    void pick(PickQuestion question, Answer<std::vector<std::optional<glm::ivec3>>> answer);
    /// The codes of a box, x fastest. A large one costs frames.
    void codes(const VoxelBox& box, Answer<std::vector<std::uint16_t>> answer);
    /// What bricks hold, in the order of the keys.
    void bricks(std::vector<BrickKey> keys, Answer<std::vector<BrickImage>> answer);
    /// The next portion of a plane goes into its reader, which nobody else touches until then.
    /// @return false: it has everything, and nothing is asked
    [[nodiscard]] bool readOn(const std::shared_ptr<LabelReader>& reader, Answer<void> answer);

    /// What lies around the seeds of each label, of codes in the interval: of each stroke, in their
    /// order, then of the seeds that are in none; only of what has voxels.
    void seedSums(const CodeInterval& interval, std::vector<SeedGroup> strokes,
        Answer<std::vector<ProbedSeeds>> answer);
    /// At place g how many members generation g has, a growth's under way included.
    void generationSizes(Answer<std::vector<std::uint32_t>> answer);

    /// At which tolerance each voxel would join. Answered none while there is more to be worked
    /// out: whoever asks again goes on from there. Once the curve is told, the field stands (it can
    /// be shown, and probe() tells of it) until something is edited or it is dropped. Refused while
    /// a stroke is under the pen or a growth runs (InvalidField, "transaction").
    void traceTolerance(const ToleranceRule& rule, Answer<std::optional<ToleranceCurve>> answer);
    void dropTolerance();
    /// What a shrinking would take if it was applied now. Answered none while that is being worked
    /// out: ask again. Once it is told it can be shown, until something is edited or it is dropped.
    /// Errors: those of the edit, and nothing is asked then. Of an answer: SeedsStay, NothingGrown
    /// too.
    [[nodiscard]] Result<void> foreseeCut(
        const ShrinkAt& shrink, Answer<std::optional<ForeseenCut>> answer);
    void dropForesight();

    /// The last step that stands and touched something; 0: none. A growth that runs is closed.
    void lastTouching(const Touch& touch, std::function<void(RowId)> answer);
    /// Called once all that was asked for before is carried out or refused.
    void afterAll(std::function<void()> then);

    /// Labels of a plane, x fastest, as they are after settle(): for export and checks. Waits; who
    /// must not uses readOn().
    [[nodiscard]] Result<std::vector<std::uint8_t>> labels(std::uint8_t plane);
    /// A sculpt layer's coverage, likewise.
    [[nodiscard]] Result<std::vector<std::uint8_t>> coverage(std::uint8_t layer);

private:
    [[nodiscard]] Result<std::vector<std::uint8_t>> read(std::uint8_t plane, Field field);

    QuestionLine& m_line;
    glm::ivec3 m_volumeSize;
};

} // namespace core
