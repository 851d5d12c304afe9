// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/pacs/PacsQuery.h"
#include "core/pacs/retrieve/PacsRetrieve.h"

#include <QByteArray>
#include <QSet>
#include <QStringList>

#include <functional>
#include <vector>

namespace core {

class DownloadFolder;

/// What a DICOM node or web server has of a requested study, and what of that is to be retrieved.
struct RetrievePlan {
    struct Series {
        QString seriesUid;
        /// the number of objects that the node counts, if its lists may be incomplete; −1: unknown
        int counted = -1;
        std::vector<InstanceHit> instances; ///< empty: the node does not list them
        QStringList missing;
        bool isPart = false; ///< only some of it is requested

        /// Whether all that is requested is listed, as far as is known.
        [[nodiscard]] bool isListed() const
        {
            return !instances.empty() && (isPart || counted <= int(instances.size()));
        }
        /// Whether everything is to be retrieved, as far as is known.
        [[nodiscard]] bool asWhole() const
        {
            return !isPart && std::size_t(missing.size()) == instances.size();
        }
        /// Whether nothing is left to be retrieved.
        [[nodiscard]] bool isHere() const { return isListed() && missing.isEmpty(); }
    };
    /// The queries with which the node is asked.
    struct Listing {
        QString nodeName;
        std::function<Result<std::vector<SeriesHit>>(const QString& study)> series;
        std::function<Result<std::vector<InstanceHit>>(const QString& study, const QString& series)>
            instances;
        /// The node can answer in pages. A server without paging returns only the first page, so a
        /// list that is shorter than the node's count is taken as incomplete.
        bool hasPages = false;
    };
    /// Errors: NodeHasNone, and those of the queries.
    [[nodiscard]] static Result<RetrievePlan> make(
        const Listing& listing, const RetrieveWish& wish);

    /// Determines what is missing. A series that is not listed completely counts as missing and is
    /// retrieved as a whole.
    void lookWhatIsMissing(const DownloadFolder& folder);
    /// Whether the node listed what to expect, of every series.
    [[nodiscard]] bool isKnown() const;
    [[nodiscard]] QStringList instances() const;
    /// How many objects the node lists or counts; 0: of some series it does neither.
    [[nodiscard]] qsizetype total() const;
    /// What is listed and not here yet.
    [[nodiscard]] QSet<QString> missing() const;
    /// SOP classes; empty if the node does not list all of them.
    [[nodiscard]] std::vector<QByteArray> classes() const;

    QString studyUid;
    std::vector<Series> series;
};

/// The queries of a node of either kind, by its findSeries() and findInstances(). Both arguments
/// must outlive it.
template <class Node>
[[nodiscard]] RetrievePlan::Listing listingOf(
    const Node& node, const Progress& progress, bool hasPages)
{
    return {.nodeName = node.name(),
        .series = [&](const QString& study) { return findSeries(node, study, progress); },
        .instances =
            [&](const QString& study, const QString& series) {
                return findInstances(node, study, series, progress);
            },
        .hasPages = hasPages};
}

/// Fills the folder @p target. Existing objects are not retrieved again, objects received before a
/// failure are kept for the next call, and the folder gets its name when everything is there.
/// @param fetch retrieves what the plan contains and returns the number of objects received
/// Errors: those of the queries, of DownloadFolder and of @p fetch.
[[nodiscard]] Result<Retrieved> retrieveInto(const QString& target,
    const RetrievePlan::Listing& listing, const RetrieveWish& wish,
    const std::function<Result<int>(const RetrievePlan& plan, const DownloadFolder& folder)>&
        fetch);

} // namespace core
