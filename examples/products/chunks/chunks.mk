# Parts of a surface that does not fit into memory, by make; the same command again goes on:
#   make -j 8 -f chunks.mk RUN='quadrille in.ply out.ply --faces 1000000 --out-of-core /scratch/a --memory 4G'
whole := $(lastword $(MAKEFILE_LIST))

all:
	+@parts=$$($(RUN) --restart --step cut) || exit; \
	while [ "$$parts" -gt 0 ]; do \
	  $(MAKE) --no-print-directory -f $(whole) $$(seq -f part-%.0f 0 $$((parts - 1))) || exit; \
	  parts=$$($(RUN) --step close) || exit; \
	done

part-%:
	@$(RUN) --step $* >/dev/null
