// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/views/Bookmarks.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"

#include <algorithm>

namespace core {

Result<void> check(const AddBookmark& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const AddBookmark& edit, Document& document)
{
    if (const Result<glm::dmat3> axes = viewAxes(edit.view, QStringLiteral("addBookmark.view"));
        !axes)
        return tl::unexpected(axes.error());
    document.bookmarks.push_back({.id = document.lastBookmarkGiven() + 1,
        .name = edit.name,
        .view = edit.view,
        .crosshairLps = edit.crosshairLps});
    return true;
}

EditEffects effects(const AddBookmark&)
{
    return documentEffects(DocumentChange::What::Bookmarks, true);
}

RowTitle rowTitle(const AddBookmark& edit, const RowFacts&)
{
    return {.code = RowTitleCode::Bookmark, .arguments = {edit.name}};
}

EditDependencies dependencies(const AddBookmark&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

Result<void> check(const RemoveBookmark& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const RemoveBookmark& edit, Document& document)
{
    const CameraBookmark* bookmark = document.bookmark(edit.bookmark);
    if (!bookmark)
        return failure(ErrorCode::InvalidField, QStringLiteral("removeBookmark.bookmark"),
            Clause::saying("there is no bookmark %1", edit.bookmark));
    document.greatestRemovedBookmark = std::max(document.greatestRemovedBookmark, edit.bookmark);
    document.bookmarks.erase(document.bookmarks.begin() + (bookmark - document.bookmarks.data()));
    return true;
}

EditEffects effects(const RemoveBookmark&)
{
    return documentEffects(DocumentChange::What::Bookmarks);
}

RowTitle rowTitle(const RemoveBookmark& edit, const RowFacts& row)
{
    const CameraBookmark* bookmark = row.document.bookmark(edit.bookmark);
    return {.code = RowTitleCode::RemoveBookmark,
        .arguments = {bookmark ? bookmark->name : QString::number(edit.bookmark)}};
}

EditDependencies dependencies(const RemoveBookmark&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
