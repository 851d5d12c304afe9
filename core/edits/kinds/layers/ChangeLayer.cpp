// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/layers/ChangeLayer.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowDeeds.h"
#include "core/edits/answers/RowFacts.h"

namespace core {

using namespace rowWords;

Result<void> check(const ChangeLayer& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const ChangeLayer& edit, Document& document)
{
    SculptLayer* layer = document.layer(edit.layer);
    if (!layer)
        return unknownLayer("changeLayer.layer", edit.layer);
    bool changed = assign(layer->name, edit.name);
    changed |= assign(layer->muted, edit.muted);
    changed |= assign(layer->solo, edit.solo);
    return changed;
}

EditEffects effects(const ChangeLayer&)
{
    return documentEffects(DocumentChange::What::Layers);
}

RowTitle rowTitle(const ChangeLayer& edit, const RowFacts& row)
{
    const Document& document = row.document;
    const SculptLayer* before = document.layer(edit.layer);
    const QString name = layerName(edit.layer, document);
    Deeds deeds;
    if (differs(edit.name, before ? &before->name : nullptr))
        deeds.add({.code = RowTitleCode::RenameLayer, .arguments = {name, *edit.name}}, {});
    if (differs(edit.solo, before ? &before->solo : nullptr)) {
        if (*edit.solo)
            deeds.add({.code = RowTitleCode::SoloLayer, .arguments = {name}},
                {.code = RowTitleCode::SoloIt});
        else
            deeds.add({.code = RowTitleCode::EndSolo, .arguments = {name}},
                {.code = RowTitleCode::EndItsSolo});
    }
    if (differs(edit.muted, before ? &before->muted : nullptr)) {
        if (*edit.muted)
            deeds.add({.code = RowTitleCode::MuteLayer, .arguments = {name}},
                {.code = RowTitleCode::MuteIt});
        else
            deeds.add({.code = RowTitleCode::UnmuteLayer, .arguments = {name}},
                {.code = RowTitleCode::UnmuteIt});
    }
    return deeds.title();
}

EditDependencies dependencies(const ChangeLayer&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
