// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/engine/EngineCommands.h"

#include <QString>

namespace core {

// Names of rows (RowName.h) that work on the surface.
// @param document before it

[[nodiscard]] QString surfaceName(const LaySurface&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const DropSurface&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const FollowMask&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const MarkSurface&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const ChangeMarks&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const SpherePush&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const PlaneScrape&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const PointDrag&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const ApplyTemplate&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const SmoothSurface&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const AttractSurface&, const EditStatistics&, const Document&);
[[nodiscard]] QString surfaceName(const WriteBack&, const EditStatistics&, const Document&);

/// Whether there is such a name of an edit.
template <class E>
concept isSurfaceEdit = requires(
    const E& edit, const EditStatistics& statistics, const Document& document)
{
    surfaceName(edit, statistics, document);
};

} // namespace core
