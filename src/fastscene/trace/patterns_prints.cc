#include "fastscene/trace/kernel/prints.h"
