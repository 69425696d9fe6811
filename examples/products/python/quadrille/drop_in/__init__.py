"""Modules with the functions of other libraries, so that a program changes one import:

    from quadrille.drop_in import fast_simplification
    from quadrille.drop_in import pyfqmr
    from quadrille.drop_in.trimesh import simplify_quadric_decimation

Arguments and results are those of these libraries. What steers how they search (agg, update_rate and so on) is taken and
has no effect: the cheapest pair is contracted first, until the target is met.
"""
