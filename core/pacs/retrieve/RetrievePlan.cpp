// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/retrieve/RetrievePlan.h"

#include "core/pacs/retrieve/DownloadFolder.h"

#include <algorithm>
#include <utility>

namespace core {

Result<RetrievePlan> RetrievePlan::make(const Listing& listing, const RetrieveWish& wish)
{
    const Result<std::vector<SeriesHit>> found = listing.series(wish.studyUid);
    if (!found)
        return tl::unexpected<Error>(found.error());
    RetrievePlan plan{.studyUid = wish.studyUid, .series = {}};
    const auto none = [&](const char* what) {
        return failure(ErrorCode::NodeHasNone, listing.nodeName, QLatin1String(what));
    };
    for (const SeriesHit& hit : *found) {
        if (hit.seriesUid.isEmpty()
            || (!wish.seriesUid.isEmpty() && hit.seriesUid != wish.seriesUid))
            continue;
        Result<std::vector<InstanceHit>> instances =
            listing.instances(wish.studyUid, hit.seriesUid);
        if (!instances)
            return tl::unexpected<Error>(instances.error());
        // Some list series of which they have nothing any more.
        if (instances->empty() && hit.instances == 0)
            continue;
        Series one{.seriesUid = hit.seriesUid,
            .counted = listing.hasPages ? hit.instances : -1,
            .instances = std::move(*instances),
            .missing = {},
            .isPart = !wish.instanceUid.isEmpty()};
        if (one.isPart) {
            std::erase_if(one.instances, [&wish](const InstanceHit& instance) {
                return instance.sopInstanceUid != wish.instanceUid;
            });
            if (one.instances.empty())
                return none("image");
        }
        plan.series.push_back(std::move(one));
    }
    if (plan.series.empty())
        return none(wish.seriesUid.isEmpty() || found->empty() ? "study" : "series");
    return plan;
}

void RetrievePlan::lookWhatIsMissing(const DownloadFolder& folder)
{
    for (Series& one : series) {
        one.missing.clear();
        for (const InstanceHit& instance : one.instances) {
            if (!one.isListed() || !folder.holds(instance.sopInstanceUid))
                one.missing.append(instance.sopInstanceUid);
        }
    }
}

bool RetrievePlan::isKnown() const
{
    return std::all_of(
        series.begin(), series.end(), [](const Series& one) { return one.isListed(); });
}

qsizetype RetrievePlan::total() const
{
    qsizetype sum = 0;
    for (const Series& one : series) {
        if (!one.isListed() && one.counted < 0)
            return 0;
        sum += one.isListed() ? qsizetype(one.instances.size()) : one.counted;
    }
    return sum;
}

QStringList RetrievePlan::instances() const
{
    QStringList all;
    for (const Series& one : series) {
        for (const InstanceHit& instance : one.instances)
            all.append(instance.sopInstanceUid);
    }
    return all;
}

QSet<QString> RetrievePlan::missing() const
{
    QSet<QString> all;
    for (const Series& one : series)
        all.unite(QSet<QString>(one.missing.begin(), one.missing.end()));
    return all;
}

std::vector<QByteArray> RetrievePlan::classes() const
{
    QSet<QByteArray> found;
    for (const Series& one : series) {
        for (const InstanceHit& instance : one.instances)
            found.insert(instance.sopClassUid.toLatin1());
    }
    if (!isKnown() || found.contains(QByteArray()))
        return {};
    return {found.begin(), found.end()};
}

Result<Retrieved> retrieveInto(const QString& target, const RetrievePlan::Listing& listing,
    const RetrieveWish& wish,
    const std::function<Result<int>(const RetrievePlan& plan, const DownloadFolder& folder)>& fetch)
{
    Result<RetrievePlan> plan = RetrievePlan::make(listing, wish);
    if (!plan)
        return tl::unexpected<Error>(plan.error());
    const QStringList instances = plan->instances();
    if (plan->isKnown() && DownloadFolder::isWhole(target, instances)) {
        DownloadFolder::removeLockLeftOver(target);
        return Retrieved{.received = 0, .kept = int(instances.size())};
    }
    Result<DownloadFolder> folder = DownloadFolder::open(target);
    if (!folder)
        return tl::unexpected<Error>(folder.error());
    plan->lookWhatIsMissing(*folder);
    Retrieved result{.received = 0, .kept = int(instances.size() - plan->missing().size())};
    if (!plan->isKnown() || !plan->missing().isEmpty()) {
        const Result<int> received = fetch(*plan, *folder);
        if (!received)
            return tl::unexpected<Error>(received.error());
        result.received = *received;
    }
    if (const Result<void> finished = folder->finish(); !finished)
        return tl::unexpected<Error>(finished.error());
    return result;
}

} // namespace core
