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

/// What a node or a server of the web holds of a wish, and what of that is to be fetched.
struct RetrievePlan {
    struct Series {
        QString seriesUid;
        std::vector<InstanceHit> instances; ///< empty: the node does not tell
        QStringList missing;
        bool isPart = false; ///< only some of it is wanted

        /// Everything, as far as anybody knows.
        [[nodiscard]] bool asWhole() const
        {
            return !isPart && std::size_t(missing.size()) == instances.size();
        }
    };
    /// How the node is asked.
    struct Listing {
        QString nodeName;
        std::function<Result<std::vector<SeriesHit>>(const QString& study)> series;
        std::function<Result<std::vector<InstanceHit>>(const QString& study, const QString& series)>
            instances;
    };
    /// NodeHasNone, and errors of the questions.
    [[nodiscard]] static Result<RetrievePlan> make(
        const Listing& listing, const RetrieveWish& wish);

    void lookWhatIsMissing(const DownloadFolder& folder);
    /// Whether the node told what to await.
    [[nodiscard]] bool isKnown() const;
    [[nodiscard]] QStringList instances() const;
    [[nodiscard]] QSet<QString> missing() const;
    /// As missing(); nothing where nobody knows what to await.
    [[nodiscard]] QSet<QString> awaited() const;
    /// SOP classes; empty where the node does not tell all of them.
    [[nodiscard]] std::vector<QByteArray> classes() const;

    QString studyUid;
    std::vector<Series> series;
};

/// A node of either kind, asked by its findSeries() and findInstances(). For as long as both live.
template <class Node>
[[nodiscard]] RetrievePlan::Listing listingOf(const Node& node, const Progress& progress)
{
    return {.nodeName = node.name(),
        .series = [&](const QString& study) { return findSeries(node, study, progress); },
        .instances =
            [&](const QString& study, const QString& series) {
                return findInstances(node, study, series, progress);
            }};
}

/// Lays the folder @p target: nothing is fetched that is there; what came before a failure stays
/// for the next time; the folder gets its name when all is there.
/// @param fetch brings what the plan awaits. @return how many objects came
/// Errors: of the questions, of DownloadFolder and of @p fetch.
[[nodiscard]] Result<Retrieved> retrieveInto(const QString& target,
    const RetrievePlan::Listing& listing, const RetrieveWish& wish,
    const std::function<Result<int>(const RetrievePlan& plan, const DownloadFolder& folder)>&
        fetch);

} // namespace core
