// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/layers/RemoveLayer.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"

namespace core {

using namespace rowWords;

Result<void> check(const RemoveLayer& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const RemoveLayer& edit, Document& document)
{
    const SculptLayer* layer = document.layer(edit.layer);
    if (!layer)
        return unknownLayer("removeLayer.layer", edit.layer);
    if (document.layers.size() == 1)
        return failure(ErrorCode::InvalidField, QStringLiteral("removeLayer.layer"),
            Clause::saying("'%1' is the only sculpt layer", layer->name));
    removeLayer(layer, document);
    return true;
}

EditEffects effects(const RemoveLayer&)
{
    return {.task = engineTask<RemoveLayer>(),
        .standsOpen = false,
        .changes = DocumentChange::What::Layers,
        .fills = fillsNothing};
}

FoldLayer foldLayer(const RemoveLayer& edit)
{
    return {.layer = std::uint8_t(edit.layer), .into = {}};
}

Result<EngineEdit> engineEdit(const RemoveLayer& edit, const Document& document)
{
    // What waited in line may meet another document than the one it was checked against.
    if (const Result<void> checked = check(edit, document); !checked)
        return tl::unexpected(checked.error());
    return EngineEdit(foldLayer(edit));
}

RowTitle rowTitle(const RemoveLayer& edit, const RowFacts& row)
{
    return {.code = RowTitleCode::DeleteLayer, .arguments = {layerName(edit.layer, row.document)}};
}

/// All of its coverage.
EditDependencies dependencies(const RemoveLayer& edit, const DependencyFacts&)
{
    dependsOn::Fields fields;
    fields.layers.set(std::size_t(edit.layer));
    return fields;
}

} // namespace core
