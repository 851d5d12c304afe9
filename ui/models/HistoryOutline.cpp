// SPDX-License-Identifier: Apache-2.0
#include "ui/models/HistoryOutline.h"

namespace ui {

namespace {

using core::RowId;

/// Lists lines of the tree: each row belongs to exactly one.
class Lister {
public:
    Lister(const core::History& history, const std::set<RowId>& unfolded,
        const std::map<RowId, int>& viewSteps, HistoryOutline& outline)
        : m_history(history)
        , m_unfolded(unfolded)
        , m_viewSteps(viewSteps)
        , m_outline(outline)
        , m_firstFork(history.rows().size() + 1, 0)
        , m_nextFork(history.rows().size() + 1, 0)
    {
        // Backwards, so that the forks of a row come oldest first.
        for (auto row = history.rows().rbegin(); row != history.rows().rend(); ++row) {
            if (history.childLastVisited(row->parent) == row->id)
                continue;
            m_nextFork[std::size_t(row->id)] = m_firstFork[std::size_t(row->parent)];
            m_firstFork[std::size_t(row->parent)] = row->id;
            ++outline.branches;
        }
    }

    void listCurrentLine()
    {
        RowId row = 0;
        do {
            const int lineIndex = int(m_outline.line.size());
            m_outline.line.push_back(row);
            listRow({.row = row, .lineIndex = lineIndex});
            row = m_history.childLastVisited(row);
        } while (row != 0);
    }

private:
    /// A row, what was changed of the view there, and what forks off it.
    void listRow(HistoryEntry entry)
    {
        const auto found = m_viewSteps.find(entry.row);
        const int viewSteps = entry.depth == 0 && found != m_viewSteps.end() ? found->second : 0;
        const bool last = m_history.childLastVisited(entry.row) == 0;
        for (entry.viewStep = 0; entry.viewStep <= viewSteps; ++entry.viewStep) {
            entry.last = last && entry.viewStep == viewSteps;
            m_outline.entries.push_back(entry);
        }
        for (RowId fork = m_firstFork[std::size_t(entry.row)]; fork != 0;
             fork = m_nextFork[std::size_t(fork)])
            listBranch(fork, entry.depth + 1, entry.lineIndex);
    }

    void listBranch(RowId first, int depth, int lineIndex)
    {
        HistoryEntry heading{.branch = first, .depth = depth, .lineIndex = lineIndex};
        for (RowId row = first; row != 0; row = m_history.childLastVisited(row)) {
            heading.row = row;
            ++heading.steps;
        }
        heading.folded = m_unfolded.count(first) == 0;
        heading.last = heading.folded;
        m_outline.entries.push_back(heading);
        if (heading.folded)
            return;
        for (RowId row = first; row != 0; row = m_history.childLastVisited(row))
            listRow({.row = row, .branch = first, .depth = depth, .lineIndex = lineIndex});
    }

    const core::History& m_history;
    const std::set<RowId>& m_unfolded;
    const std::map<RowId, int>& m_viewSteps;
    HistoryOutline& m_outline;
    std::vector<RowId> m_firstFork; ///< by row: the first child that is not on the row's own line
    std::vector<RowId> m_nextFork; ///< by such a child: the next one of the same parent
};

} // namespace

HistoryOutline HistoryOutline::of(const core::History& history, const std::set<RowId>& unfolded,
    const std::map<RowId, int>& viewSteps)
{
    HistoryOutline outline;
    Lister(history, unfolded, viewSteps, outline).listCurrentLine();
    return outline;
}

} // namespace ui
