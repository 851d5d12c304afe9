// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/ApplyTemplate.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/parts/SurfaceParts.h"
#include "core/edits/open/OpenStroke.h"

namespace core {

using namespace rowWords;

Result<void> check(const ApplyTemplate& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const ApplyTemplate&, Document& document)
{
    return changeSurface(document, true);
}

EditEffects effects(const ApplyTemplate&)
{
    return surfaceEffects(opens<ApplyTemplate>());
}

RowTitle rowTitle(const ApplyTemplate& shape, const RowFacts& row)
{
    RowTitle title = figure(RowTitleCode::TemplateOf, std::int64_t(shape.contoursLps.size()));
    title.then = {figure(RowTitleCode::Vertices, row.statistics.verticesChanged)};
    return title;
}

EditDependencies dependencies(const ApplyTemplate&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

/// A preview, for the user to decide.
OpenManner openManner(const ApplyTemplate&)
{
    return {.withoutPen = true};
}

} // namespace core
