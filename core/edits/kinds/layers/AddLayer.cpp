// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/layers/AddLayer.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"

namespace core {

namespace {

constexpr int lastLayer = 254; // 255 is where strokes of the past are tried (PastCoverage)

} // namespace

Result<void> check(const AddLayer& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const AddLayer& edit, Document& document)
{
    const int id = document.lastLayerGiven() + 1;
    if (id > lastLayer)
        return failure(ErrorCode::InvalidField, QStringLiteral("addLayer"),
            Clause::saying(
                "there are at most %1 sculpt layers, those deleted included", lastLayer));
    document.layers.push_back({.id = std::uint8_t(id), .name = edit.name});
    return true;
}

EditEffects effects(const AddLayer&)
{
    return documentEffects(DocumentChange::What::Layers);
}

RowTitle rowTitle(const AddLayer& edit, const RowFacts&)
{
    return {.code = RowTitleCode::AddLayer, .arguments = {edit.name}};
}

EditDependencies dependencies(const AddLayer&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
