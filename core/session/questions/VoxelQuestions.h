// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/growth/ProbedVoxel.h"
#include "core/growth/Tolerance.h"
#include "core/history/History.h"
#include "core/sculpt/PickRay.h"

#include <glm/glm.hpp>

#include <bitset>
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

/// Rays, and how each one finds what the user sees (the rules are those of PickVoxels,
/// VoxelReads.h).
struct PickQuestion {
    std::vector<PickRay> rays{};
    SeenBy seenBy = SeenBy::Surface;
    int thresholdCode = 0; ///< codes from this one on are material; for Surface
    /// by code >> 8, in 65535ths per sample; for Opacity
    std::vector<std::uint32_t> opacityOfCode{};
    std::bitset<256> segments{}; ///< labels; for Segment
};

/// Everything that can be asked about the voxels of a session; nothing here changes them.
/// EditSession::poll() delivers answers in order with the edits, so each one describes the state
/// after everything requested before it. Answers that are outstanding when the session closes are
/// dropped. Errors of an answer: InvalidField (places outside the volume, an invalid question),
/// OutOfMemory, EngineLost. Labels are those of all planes; seeds and growths those of one label
/// plane.
class VoxelQuestions {
public:
    template <class T> using Answer = std::function<void(Result<T>)>;

    /// @param line must outlive this
    VoxelQuestions(QuestionLine& line, const glm::ivec3& volumeSize);

    /// Value and labels (SegmentsAt.h) at each of these voxels, and the seed there.
    /// @param plane in which seeds are looked for
    void probe(std::vector<glm::ivec3> voxels, Answer<std::vector<ProbedVoxel>> answer,
        std::uint8_t plane = 0);
    /// The voxel that is visible along each ray; none if none is.
    void pick(PickQuestion question, Answer<std::vector<std::optional<glm::ivec3>>> answer);
    /// The codes of a box, x fastest. A large box delays frames.
    void codes(const VoxelBox& box, Answer<std::vector<std::uint16_t>> answer);
    /// The contents of bricks, in the order of the keys.
    void bricks(std::vector<BrickKey> keys, Answer<std::vector<BrickImage>> answer);
    /// The bricks of seed words in which a label plane holds barriers, ascending. Cost ∝ these.
    void barriers(std::uint8_t plane, Answer<std::vector<BrickImage>> answer);
    /// Reads the next portion of a plane into its reader, which must not be used until the answer
    /// comes.
    /// @return false: everything was read, and nothing is asked
    [[nodiscard]] bool readOn(const std::shared_ptr<LabelReader>& reader, Answer<void> answer);
    /// Whoever reads whole planes in portions keeps this while it does, so that others can ask
    /// isBeingRead().
    [[nodiscard]] std::shared_ptr<const void> beginReading() const { return m_readings; }
    /// Whether planes are being read by code that would have to begin again after an edit. Edits
    /// begun only in passing, such as the preview of what the pointer is on, wait for that.
    [[nodiscard]] bool isBeingRead() const { return m_readings.use_count() > 1; }

    /// Statistics around the seeds of each label of a plane, of codes in the interval: first for
    /// each stroke, in their order, then for the seeds in no stroke; only those that have voxels.
    void seedSums(std::uint8_t plane, const CodeInterval& interval, std::vector<SeedGroup> strokes,
        Answer<std::vector<ProbedSeeds>> answer);
    /// The number of members by generation, including those of a running growth.
    void generationSizes(std::uint8_t plane, Answer<std::vector<std::uint32_t>> answer);

    /// Computes at which tolerance each voxel would join (growth/Tolerance.h). An answer without a
    /// curve means that more work is left: asking again continues it. Once the curve is delivered,
    /// the field exists (it can be shown, and probe() reads it) until an edit begins or it is
    /// dropped. Refused while a stroke is open or a growth runs (InvalidField, "transaction").
    void traceTolerance(const ToleranceRule& rule, Answer<std::optional<ToleranceCurve>> answer);
    void dropTolerance();
    /// What a shrinking would remove if it were applied now. An answer without a value means that
    /// it is still being computed: ask again. Once delivered, it can be shown until an edit begins
    /// or it is dropped. Returns the errors of the edit, in which case nothing is asked. Errors of
    /// the answer also: SeedsStay, NothingGrown.
    [[nodiscard]] Result<void> previewCut(
        const ShrinkAt& shrink, Answer<std::optional<CutPreview>> answer);
    void dropCutPreview(); ///< also of what compareGrowth() keeps
    /// How many voxels of an open growth (a moving interval, for example) differ from their state
    /// when it began. Once delivered, the comparison can be shown until the growth ends. Errors of
    /// the answer also: InvalidField ("transaction") if no growth is open.
    /// @param keep voxels that are suspended in the end can be shown until the next edit that is no
    /// growth
    void compareGrowth(Answer<std::optional<GrowthComparison>> answer, bool keep = false);

    /// The last step in effect that touched something; 0: none. A running growth is committed
    /// first.
    void lastTouching(const Touch& touch, std::function<void(RowId)> answer);
    /// Calls @p then when everything requested before is carried out or refused.
    void afterAll(std::function<void()> then);

    /// Labels of a plane, x fastest, as they are after settle(): for export and checks. Blocks; a
    /// caller that must not block uses readOn().
    [[nodiscard]] Result<std::vector<std::uint8_t>> labels(std::uint8_t plane);
    /// The coverage of a sculpt layer, in the same way.
    [[nodiscard]] Result<std::vector<std::uint8_t>> coverage(std::uint8_t layer);

private:
    [[nodiscard]] Result<std::vector<std::uint8_t>> read(std::uint8_t plane, Field field);

    QuestionLine& m_line;
    glm::ivec3 m_volumeSize;
    std::shared_ptr<const void> m_readings; ///< one owner more for each that reads
};

} // namespace core
