// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/engine/SegmentProtection.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/sculpt/CutFrame.h"

#include <glm/glm.hpp>

#include <bitset>
#include <vector>

namespace core {

// Parts that the cuts share.

/// Whether a cut may be carried out: the segments to leave uncut exist, its layer exists and is
/// visible, and a command can be made of it.
/// @param field the field of its layer, for the error
template <class Cut, class Command>
[[nodiscard]] Result<void> checkCut(
    const Cut& cut, const char* field, const Result<Command>& command, const Document& document)
{
    if (const Result<void> checked =
            checkProtectedAreThere(cut.protectedSegments, cut.restore, document);
        !checked)
        return checked;
    if (const Result<void> checked = checkLayer(field, cut.layer, document); !checked)
        return checked;
    return discardValue(command);
}

/// The planes whose labels a cut reads because it leaves segments uncut.
/// @param document as it was when the cut was carried out
template <class Cut>
[[nodiscard]] std::bitset<256> labelsReadBy(const Cut& cut, const Document& document)
{
    if (cut.restore || !cut.protectedSegments)
        return {};
    return protectedLabelsOf(cut.protectedSegments, document).planes.to_ulong();
}

/// For a cut that cannot be computed.
[[nodiscard]] EditDependencies reachesNothing();

/// The dependencies of a mask that moves along a path: the coverage that its rays can meet,
/// including what the blur brings there (seed A §4.2), of all layers, muted or not. It extends from
/// the front of the volume to where the deepest cut could end that begins on the deepest surface
/// met (RowTrace::searchedTo).
/// @param labels labelsReadBy()
[[nodiscard]] EditDependencies swept(const CutFrame& frame, std::vector<glm::dvec2> path,
    double maskReachMm, const std::bitset<256>& labels, const DependencyFacts& row);
/// The same under the disc around a closed curve.
[[nodiscard]] EditDependencies sweptOutline(const CutFrame& frame,
    const std::vector<glm::dvec2>& outline, const std::bitset<256>& labels,
    const DependencyFacts& row);
[[nodiscard]] std::vector<glm::dvec2> pathOf(const std::vector<PenSample>& samples);

} // namespace core
