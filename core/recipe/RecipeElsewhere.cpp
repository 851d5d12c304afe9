// SPDX-License-Identifier: Apache-2.0
#include "core/recipe/RecipeElsewhere.h"

#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/FieldRoles.h"
#include "core/edits/schema/FieldVisitor.h"

#include <algorithm>
#include <vector>

namespace core {

namespace {

/// Maker of what every document begins with.
constexpr std::size_t fromTheStart = std::size_t(-1);
constexpr int firstLayer = 1;

using editFields::ThingNumber;
using editSchema::Presence;

/// Shows every number by which an edit names a thing, as its fields say.
template <class Take> class NumberVisitor : public editSchema::FieldVisitor<NumberVisitor<Take>> {
public:
    explicit NumberVisitor(const Take& take)
        : m_take(take)
    {
    }
    template <class Kind>
    void field(const char*, Presence, typename Kind::Value& value, const Kind& kind, const char*)
    {
        if constexpr (fieldRole<Kind>() == FieldRole::Thing)
            take(value, kind);
    }

private:
    void take(int& number, const ThingNumber& kind) { m_take(kind.thing, number); }
    void take(std::vector<int>& segments, const editFields::SegmentList&)
    {
        for (int& segment : segments)
            m_take(ThingNumber::Thing::Segment, segment);
        std::sort(segments.begin(), segments.end());
    }

    const Take& m_take;
};

template <class Take> void visitNumbers(Edit& edit, const Take& take)
{
    NumberVisitor visitor(take);
    visitEdit([&visitor](auto& known) { editSchema::visitFields(visitor, known); }, edit);
}

} // namespace

const char* RecipeElsewhere::wordFor(Kind kind)
{
    switch (kind) {
    case Kind::Segment:
        return "segment";
    case Kind::Layer:
        return "sculpt layer";
    case Kind::Piece:
        return "piece";
    case Kind::Bookmark:
        return "bookmark";
    case Kind::Measurement:
        return "measurement";
    }
    return "";
}

int RecipeElsewhere::lastGiven(Kind kind, const Document& document)
{
    switch (kind) {
    case Kind::Segment:
        return document.lastLabelGiven();
    case Kind::Layer:
        return document.lastLayerGiven();
    case Kind::Piece:
        return document.lastPieceGiven();
    case Kind::Bookmark:
        return document.lastBookmarkGiven();
    case Kind::Measurement:
        return document.lastMeasurementGiven();
    }
    return 0;
}

bool RecipeElsewhere::isThere(Kind kind, int number, const Document& document)
{
    switch (kind) {
    case Kind::Segment:
        return document.segment(number) != nullptr;
    case Kind::Layer:
        return document.layer(number) != nullptr;
    case Kind::Piece:
        return document.piece(number) != nullptr;
    case Kind::Bookmark:
        return document.bookmark(number) != nullptr;
    case Kind::Measurement:
        return document.measurement(number) != nullptr;
    }
    return false;
}

/// Of what list a member may be made.
std::optional<RecipeElsewhere::Kind> RecipeElsewhere::mayMake(const Edit& edit)
{
    using What = DocumentChange::What;
    const std::optional<What> changed = changedPart(edit);
    if (!changed)
        return std::nullopt;
    switch (*changed) {
    case What::Segments:
        return Kind::Segment;
    case What::Layers:
        return Kind::Layer;
    case What::Pieces:
        return Kind::Piece;
    case What::Bookmarks:
        return Kind::Bookmark;
    case What::Measurements:
        return Kind::Measurement;
    case What::Volume:
    case What::Surface:
    case What::Chunks:
    case What::Labels:
    case What::Coverage:
    case What::Growth:
    case What::History:
    case What::Disk:
        break; // nothing there has a number
    }
    return std::nullopt;
}

RecipeElsewhere::RecipeElsewhere(Recipe recipe)
    : m_recipe(std::move(recipe))
{
    m_numbers[fromTheStart] = firstLayer;
    followRecorded();
}

/// Where it was recorded every edit was a row, and what could be made was.
void RecipeElsewhere::followRecorded()
{
    struct State {
        Document document;
        Makers makers;
        /// Nobody knows how many segments became of islands, nor which numbers later ones had.
        bool areSegmentsUnknown = false;
    };
    std::vector<State> states{{.document = initialDocument({}),
        .makers = {{{Kind::Layer, firstLayer}, fromTheStart}}}}; // by row
    History history;
    for (std::size_t i = 0; i < m_recipe.steps.size(); ++i) {
        const State& before = states[std::size_t(history.position())];
        m_makers.push_back(before.makers);
        if (const auto* move = std::get_if<HistoryMove>(&m_recipe.steps[i])) {
            const RowId position = history.position();
            if (move->kind == HistoryMove::Kind::GoTo && move->row <= RowId(history.rows().size()))
                history.moveTo(move->row);
            else if (move->kind == HistoryMove::Kind::Undo && history.canUndo())
                history.moveTo(history.row(position).parent);
            else if (move->kind == HistoryMove::Kind::Redo && history.canRedo())
                history.moveTo(history.redoTarget());
            continue;
        }
        const auto& edit = std::get<Edit>(m_recipe.steps[i]);
        State after = before;
        const Result<bool> changed = applyToDocument(edit, after.document);
        if (!changed || (!*changed && changesDocumentOnly(edit)))
            continue; // no row came of it
        after.areSegmentsUnknown = before.areSegmentsUnknown
            || effectsOf(edit).fills.added == AddedSegments::UnknownNumber;
        const std::optional<Kind> kind = mayMake(edit);
        if (kind && !(kind == Kind::Segment && after.areSegmentsUnknown)) {
            for (int made = lastGiven(*kind, before.document) + 1;
                 made <= lastGiven(*kind, after.document); ++made)
                after.makers[{*kind, made}] = i;
        }
        HistoryRow row;
        row.edit = edit;
        history.append(std::move(row));
        states.push_back(std::move(after));
    }
    m_makers.push_back(states[std::size_t(history.position())].makers);
}

Clause RecipeElsewhere::titleOf(std::size_t step) const
{
    return Clause::saying("edit %1 (%2)", step + 1, stepName(m_recipe.steps[step]));
}

tl::expected<Edit, RecipeElsewhere::LeftOut> RecipeElsewhere::here(
    std::size_t step, const Document& now) const
{
    LeftOut leftOut{
        .entry = int(step) + 1, .bound = isBoundToStudy(m_recipe.steps[step]), .why = {}};
    if (leftOut.bound)
        return tl::unexpected(leftOut);
    Edit edit = std::get<Edit>(m_recipe.steps[step]);
    const Makers& makers = m_makers[step];
    visitNumbers(edit, [&](Kind kind, int& number) {
        if (!leftOut.why.isEmpty())
            return;
        const QString word = QLatin1String(wordFor(kind));
        const auto maker = makers.find({kind, number});
        const auto made = maker == makers.end() ? m_numbers.end() : m_numbers.find(maker->second);
        if (maker == makers.end())
            leftOut.why = Clause::saying("no edit before it makes a %1 %2", word, number);
        else if (made != m_numbers.end() && isThere(kind, made->second, now))
            number = made->second;
        else if (maker->second == fromTheStart)
            leftOut.why = Clause::saying("there is no %1 %2 here", word, number);
        else
            leftOut.why =
                Clause::saying("the %1 that %2 makes is not here", word, titleOf(maker->second));
    });
    if (!leftOut.why.isEmpty())
        return tl::unexpected(leftOut);
    return edit;
}

void RecipeElsewhere::carriedOut(std::size_t step, const Document& before, const Document& after)
{
    const auto* edit = std::get_if<Edit>(&m_recipe.steps[step]);
    const std::optional<Kind> kind = edit ? mayMake(*edit) : std::nullopt;
    if (!kind)
        return;
    if (const int last = lastGiven(*kind, after); last > lastGiven(*kind, before))
        m_numbers[step] = last;
}

std::vector<RecipeExport> RecipeElsewhere::exports() const
{
    std::vector<RecipeExport> all = m_recipe.exports;
    for (RecipeExport& target : all) {
        const auto maker = m_makers.back().find({Kind::Layer, target.layer});
        if (maker == m_makers.back().end())
            continue;
        if (const auto made = m_numbers.find(maker->second); made != m_numbers.end())
            target.layer = made->second;
    }
    return all;
}

RecipeElsewhere::Foreseen RecipeElsewhere::foreseen(Document document) const
{
    RecipeElsewhere trial = *this;
    Foreseen result{.recipe = {.path = m_recipe.path,
                        .study = m_recipe.study,
                        .steps = {},
                        .entries = {},
                        .withoutSurface = {},
                        .exports = {}},
        .leftOut = {}};
    for (std::size_t i = 0; i < m_recipe.steps.size(); ++i) {
        tl::expected<Edit, LeftOut> edit = trial.here(i, document);
        if (!edit) {
            result.leftOut.push_back(std::move(edit.error()));
            continue;
        }
        const Document before = document;
        static_cast<void>(applyToDocument(*edit, document));
        trial.carriedOut(i, before, document);
        result.recipe.steps.emplace_back(*std::move(edit));
        result.recipe.entries.push_back(int(i) + 1);
    }
    result.recipe.exports = trial.exports();
    return result;
}

} // namespace core
