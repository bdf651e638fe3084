// The loops of plain.c as baselines: one of these for each compiler and set of flags.
#pragma once

#include "baseline.h"

extern "C" {
#include "plain.h"
}

namespace motorway::bench {

template <class T, class M> work bind_plain(const plain_table &table, const problem<T, M> &p);
bool can_run(const plain_table &table);

} // namespace motorway::bench
