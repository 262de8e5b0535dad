#include "fastscene/trace/kernel/stone.h"
