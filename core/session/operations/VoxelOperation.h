// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/engine/EngineEdit.h"
#include "core/session/past/SketchedSeeds.h"
#include "core/session/state/Operation.h"

#include <deque>

namespace core {

struct PenSample;

/// An edit of voxels, which may also change the document: one engine transaction, and one row if it
/// changed anything.
class VoxelOperation final : public OpenOperation {
public:
    enum class Kind {
        Whole, ///< the edit is complete
        Interactive, ///< the user continues it until end()
    };
    /// @param again a row that is carried out again when a session is opened; 0: a new row
    VoxelOperation(Edit edit, Kind kind, RowId again = 0);

    // For interactive operations only:
    void extend(SessionState& state, const StrokeExtension& extension) override;
    void end(SessionState& state, Ending ending) override;
    [[nodiscard]] bool open() const override { return m_kind == Kind::Interactive && !m_ending; }
    [[nodiscard]] bool isGrowth() const
    {
        return m_edit.is<GrowSteps>() || m_edit.is<ChangeInterval>() || m_edit.is<ResumeGrowth>();
    }
    /// Whether it takes a growth back from a sketch, step by step.
    [[nodiscard]] bool isBackwards() const;
    /// Whether nothing of it remains: the engine never opened it, or something has failed.
    [[nodiscard]] bool refused() const { return m_refused || m_failed; }
    /// Whether it is only shown for the user to decide; the next operation takes it back.
    [[nodiscard]] bool isPreview() const { return m_edit.is<GrowFromSeeds>(); }
    /// The same for an interval of values; it keeps nothing for the next one.
    [[nodiscard]] bool isThreshold() const { return m_edit.is<ThresholdSegment>(); }
    [[nodiscard]] bool standsOpen() const override
    {
        return isGrowth() || isPreview() || isThreshold() || m_edit.is<PeelCut>()
            || m_edit.is<ShrinkSteps>() || isBackwards();
    }
    [[nodiscard]] Ending usualEnding() const override
    {
        return standsOpen() && !isPreview() && !isThreshold() ? Ending::Commit : Ending::Rollback;
    }

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    [[nodiscard]] bool done() const override { return m_finished || (m_refused && m_ending); }
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) override;
    [[nodiscard]] bool foresee(Document& document) const override;

private:
    void extendDrill(SessionState& state, const std::vector<PenSample>& samples);
    void extendPath(SessionState& state, const std::vector<glm::dvec3>& pointsLps, bool lifted,
        const std::vector<double>& pressures);
    void setPeelDepth(SessionState& state, double depthMm);
    void setShrinkSteps(SessionState& state, int steps);
    void extendGrowth(SessionState& state, EngineExtension extension);
    void setInterval(SessionState& state, double lower, double upper);
    void forgetPreview(SessionState& state);
    [[nodiscard]] Result<EngineEdit> engineEdit(const Document& document);
    [[nodiscard]] ShrinkTo shrinkTo() const;
    void askBefore(SessionState& state, const EngineEdit& edit);
    void takeBefore(const EngineResult& result);
    void liftPen();
    void submitWaiting(SessionState& state);
    void finish(SessionState& state, EngineResult&& result);
    [[nodiscard]] Edit carriedOut(const EngineResult& result) const;

    Edit m_edit;
    Kind m_kind;
    RowId m_again = 0;
    std::optional<DrillPathSampler> m_path; ///< of a drill or laser stroke
    std::uint32_t m_firstGeneration = 0; ///< of a shrinking
    std::deque<EngineExtension> m_waiting;
    std::optional<Ending> m_ending;
    std::optional<Ticket> m_asked; ///< for the state of voxels where seeds are sketched
    SeedPlacement m_seeds; ///< until the answer arrives
    std::optional<SketchedSeeds> m_sketched;
    std::optional<Ticket> m_begun;
    std::optional<Ticket> m_ended;
    bool m_refused = false; ///< the engine never opened it
    bool m_failed = false; ///< something failed, so nothing of it may remain
    bool m_finished = false;
};

} // namespace core
