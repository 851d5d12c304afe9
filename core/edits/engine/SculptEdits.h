// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/edits/kinds/Edits.h"
#include "core/engine/EngineCommands.h"

#include <optional>
#include <variant>
#include <vector>

namespace core {

/// The edits that write the coverage of a sculpt layer: each by the greater value where it carves,
/// by the lesser where it restores.
using SculptEdit = std::variant<DrillStroke, BrushStroke, PeelCut, ScissorsCut, LaserStroke>;

[[nodiscard]] std::optional<SculptEdit> sculptEdit(const Edit& edit);
[[nodiscard]] Edit plainEdit(const SculptEdit& edit);
[[nodiscard]] int layerOf(const SculptEdit& edit);
[[nodiscard]] bool restores(const SculptEdit& edit);
/// Whether what is seen decides where it cuts.
[[nodiscard]] bool startsOnSurface(const SculptEdit& edit);

/// What of a cut can be revised, as it is; absent: it has no such thing.
struct StrokeParameters {
    int layer = 1;
    std::optional<double> radiusMm{};
    std::optional<double> sideMm{};
    std::optional<double> widthMm{};
    std::optional<double> heightMm{};
    std::optional<double> factor{}; ///< of its outline as it is: 1
    std::optional<double> depthMm{};
    std::optional<double> softnessMm{};
    std::optional<bool> throughGaps{};
    bool operator==(const StrokeParameters&) const = default;
};
[[nodiscard]] StrokeParameters parametersOf(const SculptEdit& edit);

/// The edit as @p revision makes it. Errors: InvalidField for what it has not.
[[nodiscard]] Result<SculptEdit> revised(SculptEdit edit, const ReviseStroke& revision);

/// Whether an edit writes a layer's coverage otherwise than by a cut, so that the cuts alone do not
/// make up what stands there.
[[nodiscard]] bool writesLayer(const Edit& edit, int layer);

/// An edit in one go, as submitWhole() takes it.
struct WholeCut {
    EngineEdit edit;
    std::vector<EngineExtension> extensions;
};

/// What an edit cuts by itself, into an empty layer; what a restoring one gives back is cut too.
/// Errors: InvalidField.
[[nodiscard]] Result<WholeCut> cutAlone(
    const SculptEdit& edit, const Document& document, std::uint8_t layer);

} // namespace core
