// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "tests/reference/fields/DenseFields.h"
#include "tests/reference/growth/Growth.h"
#include "tests/reference/growth/GrowthCut.h"
#include "tests/reference/growth/Tolerance.h"
#include "tests/reference/sculpt/Capsules.h"
#include "tests/reference/sculpt/Drill.h"
#include "tests/reference/sculpt/Laser.h"
#include "tests/reference/sculpt/Peel.h"

#include <optional>
#include <type_traits>
#include <variant>

namespace reference {

/// What ReferenceEngine does, and its state. Apart from it, so that a test which only runs a
/// session on it need not know every command of an engine.
class Oracle {
public:
    core::Result<void> openVolume(const glm::ivec3& size, std::span<const std::uint16_t> codes);
    core::Ticket submit(core::EngineCommand command);
    [[nodiscard]] std::vector<core::EngineResult> collect();
    void setWakeUp(std::function<void()> wakeUp) { m_wakeUp = std::move(wakeUp); }
    [[nodiscard]] core::GrowthProgress growthProgress() const;

    [[nodiscard]] const DenseFields& fields() const { return m_fields; }
    [[nodiscard]] DenseArray<std::uint8_t> carved() const;

private:
    /// An edit that is done once it has begun.
    struct Done {
        std::optional<std::int32_t> to{}; ///< how far a ray searched
        [[nodiscard]] std::optional<std::int32_t> searchedTo() const { return to; }
    };
    /// Likewise, and may be done anew for another generation; it tells how far the growth is now.
    struct Shrunk {
        core::ShrinkGrowth edit;
        std::uint32_t to = 0;
    };
    /// Of a cut what it was asked for, and how far it is.
    struct CutBack {
        core::CutGrowth edit;
        CutDone done;
    };
    /// Likewise; it may be told not to remember what it never does.
    struct Spread { };
    using Work = std::variant<Done, Shrunk, CutBack, Spread, Growth, Drill, Capsules, Peel, Laser>;
    template <class W, class... Ws> static constexpr bool isOf = (std::is_same_v<W, Ws> || ...);
    /// Work that moves no growth to another generation. A kind that is added does not compile until
    /// it is listed here or says what it does to a growth (generationBefore(), report()).
    template <class W>
    static constexpr bool movesNoGrowth = isOf<W, Done, Spread, Drill, Capsules, Peel, Laser>;
    /// The open edit and the state at its beginning.
    struct Transaction {
        DenseFields before;
        Work work;
    };
    using Outcome = core::Result<std::optional<core::EngineResult>>;

    [[nodiscard]] Outcome carryOut(core::BeginEdit& command);
    [[nodiscard]] Outcome carryOut(core::ExtendEdit& command);
    [[nodiscard]] std::optional<std::int32_t> searchedTo() const;
    [[nodiscard]] Outcome carryOut(core::EndEdit& command);
    [[nodiscard]] Outcome carryOut(core::SwapBricks& command);
    [[nodiscard]] Outcome carryOut(core::XorBricks& command);
    [[nodiscard]] Outcome carryOut(core::ReadSeedWords& command);
    [[nodiscard]] core::Result<void> checkImages(
        const std::vector<core::BrickImage>& images, bool mayBeEmpty) const;
    [[nodiscard]] std::vector<core::BrickImage> imagesNow(
        const std::vector<core::BrickKey>& keys) const;
    [[nodiscard]] Outcome put(const core::LabelGuard& guard,
        const std::vector<core::BrickImage>& now, const std::vector<core::BrickImage>& images);
    [[nodiscard]] Outcome carryOut(core::MuteLayers& command);
    [[nodiscard]] Outcome carryOut(core::ReadBricks& command);
    [[nodiscard]] Outcome carryOut(core::ReadBarriers& command);
    [[nodiscard]] Outcome carryOut(core::ReadCodes& command);
    [[nodiscard]] Outcome carryOut(core::ProbeVoxels& command);
    [[nodiscard]] Outcome carryOut(core::ProbeSeeds& command);
    [[nodiscard]] Outcome carryOut(core::PickVoxels& command);
    [[nodiscard]] Outcome carryOut(core::CountGenerations& command);
    [[nodiscard]] Outcome carryOut(core::TraceTolerance& command);
    [[nodiscard]] Outcome carryOut(core::DropTolerance& command);
    [[nodiscard]] Outcome carryOut(core::PreviewCut& command);
    [[nodiscard]] Outcome carryOut(core::DropCutPreview& command);
    [[nodiscard]] Outcome carryOut(core::CompareGrowth& command);
    [[nodiscard]] core::Result<void> checkCut(const core::CutGrowth& edit) const;
    [[nodiscard]] core::Result<void> check(const core::GrowBurst& edit) const;
    [[nodiscard]] core::Result<void> checkGroups(const std::vector<core::SeedGroup>& groups) const;

    [[nodiscard]] core::Result<Work> begin(core::SeedPlacement& edit);
    [[nodiscard]] core::Result<Work> begin(core::GrowBurst& edit);
    [[nodiscard]] core::Result<Work> begin(core::ShrinkGrowth& edit);
    [[nodiscard]] core::Result<Work> begin(core::CutGrowth& edit);
    [[nodiscard]] core::Result<Work> begin(core::PaintBarrier& edit);
    [[nodiscard]] core::Result<Work> begin(core::BarrierListed& edit);
    [[nodiscard]] core::Result<Work> begin(core::SpreadLabels& edit);
    [[nodiscard]] core::Result<Work> begin(core::DrillCut& edit);
    [[nodiscard]] core::Result<Work> begin(core::EraseLabel& edit);
    [[nodiscard]] core::Result<Work> begin(core::PaintLabel& edit);
    [[nodiscard]] core::Result<Work> begin(core::CapsuleCut& edit);
    [[nodiscard]] core::Result<Work> begin(core::ShellPeel& edit);
    [[nodiscard]] core::Result<Work> begin(core::OutlineCut& edit);
    [[nodiscard]] core::Result<Work> begin(core::LabelCarved& edit);
    [[nodiscard]] core::Result<Work> begin(core::LabelSeen& edit);
    [[nodiscard]] core::Result<Work> begin(core::LabelListed& edit);
    [[nodiscard]] core::Result<Work> begin(core::LabelPlanes& edit);
    [[nodiscard]] core::Result<Work> begin(core::RelabelListed& edit);
    [[nodiscard]] core::Result<Work> begin(core::LabelOutlined& edit);
    [[nodiscard]] core::Result<Work> begin(core::LabelThreshold& edit);
    [[nodiscard]] core::Result<Work> begin(core::LabelScissors& edit);
    [[nodiscard]] core::Result<Work> begin(core::MapLabels& edit);
    [[nodiscard]] core::Result<Work> begin(core::MapPlanes& edit);
    [[nodiscard]] core::Result<Work> begin(core::CoverLabel& edit);
    [[nodiscard]] core::Result<Work> begin(core::FoldLayer& edit);
    [[nodiscard]] core::Result<Work> begin(core::LaserCut& edit);

    // What an open edit makes of an extension that is meant for it; all others are refused.
    [[nodiscard]] core::Result<void> extend(Drill& stroke, core::DrillPath& path);
    [[nodiscard]] core::Result<void> extend(Laser& stroke, core::DrillPath& path);
    [[nodiscard]] core::Result<void> extend(Capsules& stroke, core::CapsulePath& path);
    [[nodiscard]] core::Result<void> extend(Peel& peel, core::PeelDepth& depth);
    [[nodiscard]] core::Result<void> extend(Shrunk& shrunk, core::ShrinkTo& to);
    [[nodiscard]] core::Result<void> extend(CutBack& cut, core::CutFurther& further);
    [[nodiscard]] core::Result<void> extend(Spread& spread, core::ForgetSpread& forget);
    [[nodiscard]] core::Result<void> extend(Growth& growth, core::GrowAdvance& advance);
    [[nodiscard]] core::Result<void> extend(Growth& growth, core::GrowPause& pause);
    [[nodiscard]] core::Result<void> extend(Growth& growth, core::GrowAnew& anew);
    template <class Other, class Extension>
    [[nodiscard]] core::Result<void> extend(Other& other, Extension& extension);

    // What is told of the growth that an open edit moves.

    /// The generation that it has again if the edit is taken back.
    [[nodiscard]] static std::uint32_t generationBefore(const Growth& growth);
    [[nodiscard]] static std::uint32_t generationBefore(const Shrunk& shrunk);
    [[nodiscard]] static std::uint32_t generationBefore(const CutBack& cut);
    template <class W>
    requires movesNoGrowth<W>
    [[nodiscard]] static std::uint32_t generationBefore(const W&) { return 0; }
    /// When it ends.
    static void report(const Growth& growth, core::EngineResult& result);
    static void report(const Shrunk& shrunk, core::EngineResult& result);
    static void report(const CutBack& cut, core::EngineResult& result);
    template <class W>
    requires movesNoGrowth<W>
    static void report(const W&, core::EngineResult&) { }
    /// While it is open; a shrinking has no progress.
    static void report(const Growth& growth, core::GrowthProgress& progress);
    static void report(const Shrunk&, core::GrowthProgress&) { }
    static void report(const CutBack& cut, core::GrowthProgress& progress);
    template <class W>
    requires movesNoGrowth<W>
    static void report(const W&, core::GrowthProgress&) { }

    DenseArray<std::uint16_t> m_codes;
    DenseFields m_fields;
    std::bitset<256> m_muted; ///< layers
    std::optional<ToleranceField> m_tolerance;
    std::optional<Transaction> m_open;
    std::vector<core::EngineResult> m_results;
    core::Ticket m_lastTicket = 0;
    std::function<void()> m_wakeUp;
};

} // namespace reference
