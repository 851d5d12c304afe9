// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/engine/CommandQueue.h"
#include "gpu/engine/EditTransaction.h"
#include "gpu/engine/EngineThread.h"
#include "gpu/engine/IdleWork.h"
#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/frame/EditWorker.h"
#include "gpu/kernels/growth/GrowthMarks.h"
#include "gpu/kernels/labels/PickKernel.h"
#include "gpu/kernels/shrink/CutPreviewer.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gpu {

/// The implementation of core::EditEngine by compute shaders. Commands wait in a queue that the
/// engine thread processes one slice at a time; a growth runs in batches, and other commands and
/// frames are served between them.
///
/// If the GPU refuses memory or a command, the edit is refused and every brick is restored
/// (gl/GlFailure.h): a result without an error never belongs to a failed edit. If the restoring
/// fails too, every command is refused until a volume is opened. The loss of the context is
/// reported once, by a result that belongs to no command; from then on everything is refused.
///
/// The members of core::EditEngine are called on the session's thread, those of EditWorker on the
/// engine's.
class GpuEditEngine final : public CommandQueue, public EditWorker {
public:
    /// Construct and destroy it on the engine thread. Throws ShaderError.
    explicit GpuEditEngine(const EditContext& context);
    ~GpuEditEngine() override;

    core::Result<void> openVolume(
        const glm::ivec3& size, std::span<const std::uint16_t> codes) override;
    core::Result<void> takeVolume(
        const glm::ivec3& size, std::vector<std::uint16_t> codes) override;

    bool work() override; ///< throws nothing
    void showSegments(const std::bitset<256>& labels, const std::bitset<256>& translucent) override;
    void showPieces(const std::vector<PieceSource>& sources) override;
    void showGrowth(std::uint8_t plane) override;
    void showAtTolerance(const std::optional<ToleranceDisplay>& shown) override;
    void warmUp() override;
    void expectEditableRanges() override;
    /// Bytes of GPU memory that the bricked fields take.
    [[nodiscard]] std::size_t brickBytes() const;

private:
    using Clock = EngineThread::Clock;
    static constexpr double sliceMilliseconds = 10.0;
    [[nodiscard]] static double millisecondsSince(Clock::time_point start);

    /// @param fill makes the textures of the volume
    core::Result<void> open(
        const glm::ivec3& size, std::size_t codes, const std::function<core::Result<void>()>& fill);
    [[nodiscard]] bool growthIsDue();
    void growOneSlice();
    [[nodiscard]] bool readingIsDue() const;
    void readOneSlice();
    static constexpr std::size_t leastTraced = 32; ///< bricks
    static constexpr std::size_t mostTraced = 4096;
    void close();
    void lose(const core::Error& why);
    [[nodiscard]] bool contextLost() const
    {
        return m_lost && m_lost->code == core::ErrorCode::ContextLost;
    }
    void abandon(const core::Error& why);
    bool workUnguarded();
    void followUpLater(const core::Error& why);
    void carryOut(Waiting& next);
    void publishProgress();
    [[nodiscard]] core::Result<void> checkKeys(std::span<const core::BrickKey> keys) const;

    /// Each returns the result to deliver, or none if the command has none.
    using Outcome = core::Result<std::optional<core::EngineResult>>;
    Outcome attempt(core::EngineCommand& command);
    /// Cleans up after a command that threw. Only the commands named below leave anything behind.
    template <class Command> void clearAfter(const Command&, const core::Error&) { }
    void clearAfter(const core::ExtendEdit& command, const core::Error& why);
    void clearAfter(const core::EndEdit& command, const core::Error& why);
    void clearAfter(const core::TraceTolerance& command, const core::Error& why);
    void clearAfter(const core::PreviewCut& command, const core::Error& why);
    void clearAfter(const core::CompareGrowth& command, const core::Error& why);
    Outcome carryOut(const core::BeginEdit& command);
    Outcome carryOut(const core::ExtendEdit& command);
    Outcome carryOut(const core::EndEdit& command);
    Outcome carryOut(core::SwapBricks& command);
    Outcome carryOut(core::XorBricks& command);
    Outcome carryOut(const core::MuteLayers& command);
    Outcome carryOut(const core::ReadBricks& command);
    Outcome carryOut(const core::ReadBarriers& command);
    Outcome carryOut(const core::ReadSeedWords& command);
    Outcome carryOut(const core::ReadCodes& command);
    Outcome carryOut(const core::ProbeVoxels& command);
    Outcome carryOut(const core::ProbeSeeds& command);
    Outcome carryOut(const core::PickVoxels& command);
    Outcome carryOut(const core::CountGenerations& command);
    Outcome carryOut(const core::TraceTolerance& command);
    Outcome carryOut(const core::DropTolerance& command);
    Outcome carryOut(const core::PreviewCut& command);
    Outcome carryOut(const core::DropCutPreview& command);
    Outcome carryOut(const core::CompareGrowth& command);
    [[nodiscard]] core::Result<void> checkImages(
        const std::vector<core::BrickImage>& images, bool mayBeEmpty) const;
    Outcome put(const core::LabelGuard& guard, const std::vector<core::BrickImage>& now,
        std::vector<core::BrickImage> images);
    /// Marks what the edit that has ended leaves to be shown.
    void endMarks(core::Ending ending, std::optional<std::uint8_t> growing,
        std::span<const core::BrickChange> changes);
    /// Stops showing the tolerance field, because what it was computed from is about to change.
    void hideTolerance();

    EngineThread& m_thread;
    VolumeTextures& m_textures;
    std::atomic<bool> m_expectsRanges = false; ///< of what is open; set on the session's thread

    // Engine thread.
    WorkBy m_work;
    EditPrograms m_programs;
    FieldPrograms m_fieldPrograms;
    IdleWork m_idleWork;
    PickKernel m_picks;
    std::unique_ptr<VoxelFields> m_fields;
    CutPreviewer m_cutPreviewer;
    GrowthMarks m_growthMarks;
    std::unique_ptr<EditTransaction> m_transaction;
    std::optional<core::Error> m_lost; ///< why every command is refused until a volume is opened
    std::bitset<256> m_shownLabels;
    std::bitset<256> m_translucentLabels;
    std::vector<PieceSource> m_shownPieces;
    std::uint8_t m_growthPlane = 0; ///< whose growth pictures show
    std::optional<ToleranceDisplay> m_atTolerance;
    std::unique_ptr<ToleranceKernel> m_trace;
    std::size_t m_tracedAtOnce = leastTraced; ///< bricks
    double m_editMilliseconds = 0.0; ///< time spent on the open transaction
    int m_followUpsFailed = 0; ///< consecutive failures
    Clock::time_point m_followUpsFrom; ///< after a failure nothing is tried before
    int m_ringsPerSlice = GrowthKernel::ringsPerBatch;
    Clock::time_point m_nextGeneration;
};

} // namespace gpu
