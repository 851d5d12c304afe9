// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace core {

/// Asks the system for large pages for memory that is about to be written for the first time: a
/// volume then needs a hundred page faults instead of sixty thousand. It changes nothing else.
void useLargePages(void* memory, std::size_t bytes);

/// Gives memory that is not needed any more back to the system, before it is freed as usual: its
/// whole pages take no memory until they are written again. What they hold is lost.
void giveBackPages(void* memory, std::size_t bytes);

/// Reserves memory for @p count values in an empty vector, in large pages.
template <class Value> void reserveInLargePages(std::vector<Value>& values, std::size_t count)
{
    values.reserve(count);
    useLargePages(values.data(), count * sizeof(Value));
}

/// Resizes an empty vector to @p count copies of a value, zero by default, in large pages.
template <class Value>
void resizeInLargePages(std::vector<Value>& values, std::size_t count, const Value& value = {})
{
    reserveInLargePages(values, count);
    values.resize(count, value);
}

} // namespace core
