// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/layers/MergeLayers.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"

namespace core {

using namespace rowWords;

Result<void> check(const MergeLayers& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const MergeLayers& edit, Document& document)
{
    const SculptLayer* from = document.layer(edit.from);
    if (!from)
        return unknownLayer("mergeLayers.from", edit.from);
    const SculptLayer* into = document.layer(edit.into);
    if (!into)
        return unknownLayer("mergeLayers.into", edit.into);
    if (from == into)
        return failure(ErrorCode::InvalidField, QStringLiteral("mergeLayers.into"),
            Clause::saying("a layer cannot be merged into itself"));
    if (document.carves(*from) != document.carves(*into)) {
        const SculptLayer& silent = document.carves(*from) ? *into : *from;
        return failure(ErrorCode::InvalidField, QStringLiteral("mergeLayers.into"),
            Clause::saying("sculpt layer '%1' %2 and the other is not: what is seen would change",
                silent.name, document.whyItDoesNotCarve(silent)));
    }
    removeLayer(from, document);
    return true;
}

EditEffects effects(const MergeLayers&)
{
    return {.task = engineTask<MergeLayers>(),
        .standsOpen = false,
        .changes = DocumentChange::What::Layers,
        .fills = fillsNothing};
}

FoldLayer foldLayer(const MergeLayers& edit)
{
    return {.layer = std::uint8_t(edit.from), .into = std::uint8_t(edit.into)};
}

Result<EngineEdit> engineEdit(const MergeLayers& edit, const Document& document)
{
    // What waited in line may meet another document than the one it was checked against.
    if (const Result<void> checked = check(edit, document); !checked)
        return tl::unexpected(checked.error());
    return EngineEdit(foldLayer(edit));
}

RowTitle rowTitle(const MergeLayers& edit, const RowFacts& row)
{
    return {.code = RowTitleCode::MergeLayers,
        .arguments = {layerName(edit.from, row.document), layerName(edit.into, row.document)}};
}

/// All of their coverage.
EditDependencies dependencies(const MergeLayers& edit, const DependencyFacts&)
{
    dependsOn::Fields fields;
    fields.layers.set(std::size_t(edit.from)).set(std::size_t(edit.into));
    return fields;
}

} // namespace core
