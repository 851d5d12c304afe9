// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/SpherePush.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/edits/kinds/surface/parts/SurfaceParts.h"

namespace core {

Result<void> check(const SpherePush& edit, const Document& document)
{
    if (const Result<void> pressed = checkPressures(edit.path, "spherePush"); !pressed)
        return pressed;
    return checkApplied(edit, document);
}

Result<bool> apply(const SpherePush&, Document& document)
{
    return changeSurface(document, true);
}

EditEffects effects(const SpherePush&)
{
    return surfaceEffects(opens<SpherePush>());
}

RowTitle rowTitle(const SpherePush& push, const RowFacts& row)
{
    return strokeTitle(RowTitleCode::SpherePush, push.path, row.statistics);
}

EditDependencies dependencies(const SpherePush&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

Result<void> check(const PointDrag& edit, const Document& document)
{
    if (const Result<void> pressed = checkPressures(edit.path, "pointDrag"); !pressed)
        return pressed;
    return checkApplied(edit, document);
}

Result<bool> apply(const PointDrag&, Document& document)
{
    return changeSurface(document, true);
}

EditEffects effects(const PointDrag&)
{
    return surfaceEffects(opens<PointDrag>());
}

RowTitle rowTitle(const PointDrag& drag, const RowFacts& row)
{
    return strokeTitle(RowTitleCode::DragPoint, drag.path, row.statistics);
}

EditDependencies dependencies(const PointDrag&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

Result<void> check(const SmoothSurface& edit, const Document& document)
{
    if (const Result<void> pressed = checkPressures(edit.path, "smooth"); !pressed)
        return pressed;
    return checkApplied(edit, document);
}

Result<bool> apply(const SmoothSurface&, Document& document)
{
    return changeSurface(document, true);
}

EditEffects effects(const SmoothSurface&)
{
    return surfaceEffects(opens<SmoothSurface>());
}

RowTitle rowTitle(const SmoothSurface& smooth, const RowFacts& row)
{
    return strokeTitle(RowTitleCode::SmoothSurface, smooth.path, row.statistics);
}

EditDependencies dependencies(const SmoothSurface&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

Result<void> check(const AttractSurface& edit, const Document& document)
{
    if (const Result<void> pressed = checkPressures(edit.path, "attract"); !pressed)
        return pressed;
    return checkApplied(edit, document);
}

Result<bool> apply(const AttractSurface&, Document& document)
{
    return changeSurface(document, true);
}

EditEffects effects(const AttractSurface&)
{
    return surfaceEffects(opens<AttractSurface>());
}

RowTitle rowTitle(const AttractSurface& attract, const RowFacts& row)
{
    return strokeTitle(RowTitleCode::AttractToEdge, attract.path, row.statistics);
}

EditDependencies dependencies(const AttractSurface&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
