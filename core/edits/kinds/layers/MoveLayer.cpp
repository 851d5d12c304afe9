// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/layers/MoveLayer.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"

namespace core {

using namespace rowWords;

Result<void> check(const MoveLayer& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const MoveLayer& edit, Document& document)
{
    const SculptLayer* layer = document.layer(edit.layer);
    if (!layer)
        return unknownLayer("moveLayer.layer", edit.layer);
    std::vector<SculptLayer>& layers = document.layers;
    return moveTo(layers, layers.begin() + (layer - layers.data()), edit.place);
}

EditEffects effects(const MoveLayer&)
{
    return documentEffects(DocumentChange::What::Layers);
}

RowTitle rowTitle(const MoveLayer& edit, const RowFacts& row)
{
    return {.code = RowTitleCode::MoveLayer,
        .arguments = {layerName(edit.layer, row.document), TitleNumber{edit.place}}};
}

EditDependencies dependencies(const MoveLayer&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
